# Second names of scripts, for those who look for them here. The build itself is CMake's
# (CMakePresets.json); ./demo and ./test install what is missing and walk through it.

.DEFAULT_GOAL := build
.PHONY: build demo test docs format check clean help
MAKEFLAGS += --no-print-directory

build: ## the program: build/release/bin/coppice
	@tools/setup --for demo
	@tools/build demo coppice_cli

demo: ## ./demo: an experiment on the Stanford dragon, with its report in out/
	@./demo

test: ## ./test: all tests
	@./test

docs: ## the site of the documentation: build/docs/html/index.html
	@tools/setup --for docs
	@tools/build_docs

format: ## clang-format on every source file
	@tools/setup --for checks
	@tools/format

check: build ## what CI checks beside the tests: format, layers, docs, clang-tidy
	@tools/setup --for checks
	@tools/format --check
	@tools/check_layers
	@tools/check_docs
	@tools/tidy

clean: ## removes build/ (scenes/ and out/ stay)
	@rm -rf build

help: ## this list
	@sed -n 's/^\([a-z]*\):.*## /\1\t/p' $(MAKEFILE_LIST) | expand -t 10
