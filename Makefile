# Two doors for a newcomer: `make demo` and `make test`. Each installs what is missing, builds
# and runs. The build itself is CMake's (CMakePresets.json); this file only walks through it.

.DEFAULT_GOAL := build
.PHONY: build demo test docs format check clean help
MAKEFLAGS += --no-print-directory

coppice := build/release/bin/coppice
jobs := $(shell nproc)

build: ## the program: build/release/bin/coppice
	@tools/setup
	@tools/build release coppice_cli

demo: build ## an experiment on the Stanford dragon, with its report in out/
	@if tools/fetch_scenes dragon; then \
		scene=dragon; \
	else \
		echo "No dragon without network: the demo runs on a made-up terrain instead."; \
		scene=terrain; \
		mkdir -p scenes; \
		[ -e scenes/terrain.obj ] || \
			$(coppice) generate terrain --triangles 200000 -o scenes/terrain.obj; \
	fi && \
	$(coppice) experiment scenes/$$scene.obj --seeds 3 --out out/$$scene && \
	echo "Open out/$$scene/report.html"

test: ## all tests
	@tools/setup
	@tools/build release
	@ctest --preset release --parallel $(jobs) --output-junit tests.xml

docs: ## the site of the documentation: build/docs/html/index.html
	@tools/setup --docs
	@tools/build_docs

format: ## clang-format on every source file
	@tools/setup --checks
	@tools/format

check: build ## what CI checks beside the tests: format, layers, docs, clang-tidy
	@tools/setup --checks
	@tools/format --check
	@tools/check_layers
	@tools/check_docs
	@tools/tidy

clean: ## removes build/ (scenes/ and out/ stay)
	@rm -rf build

help: ## this list
	@sed -n 's/^\([a-z]*\):.*## /\1\t/p' $(MAKEFILE_LIST) | expand -t 10
