"""Shared by the Python checks: the project's files, and how an offence is reported."""

import argparse
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
CODE_FOLDERS = ("include", "src", "workbench", "apps", "bench", "examples", "fuzz", "tests", "python", "dist")
CODE_SUFFIXES = {".h", ".hpp", ".cpp", ".inl"}


class Offences:
    """Collects `file:line: message`; finish() prints them and ends the tool."""

    def __init__(self):
        self._found = []

    def add(self, path, line, message):
        self._found.append((str(path), line, message))

    def finish(self):
        for path, line, message in sorted(self._found):
            print(f"{path}:{line}: {message}")
        sys.exit(1 if self._found else 0)


def parse_no_arguments(doc):
    """For a tool that takes none: --help prints its docstring, anything else is refused."""
    style = argparse.RawDescriptionHelpFormatter
    argparse.ArgumentParser(description=doc, formatter_class=style).parse_args()


def code_files():
    """Paths of all code, relative to the root, sorted."""
    return sorted(
        path.relative_to(ROOT)
        for folder in CODE_FOLDERS
        for path in (ROOT / folder).rglob("*")
        if path.suffix in CODE_SUFFIXES and "node_modules" not in path.parts
    )


def lines_of(path):
    """The lines of a file, numbered from 1."""
    return enumerate((ROOT / path).read_text(encoding="utf-8").splitlines(), start=1)
