"""The rules for fenced blocks in the documentation, for tools/check_docs.

Every block names its language, and every language but one is checked:

  cpp      equals `<!-- file: PATH -->`, or is part of `<!-- excerpt: PATH -->` (indentation aside), so
           that the build compiles and the tests run it; any other is a whole program that compiles
  sh       `bash -n` takes it, and what it gives to `coppice VERB` are options of that verb
  cmake    CMake's parser takes it
  python   compiles
  json     parses
  text     output, formulas and layouts. It is not checked; hence C++ and command lines may not stand in it
"""

import concurrent.futures
import json
import os
import re
import subprocess
import tempfile
from dataclasses import dataclass

from project import ROOT, lines_of

MARK = re.compile(r"<!-- (file|excerpt): (\S+) -->$")
FENCE = re.compile(r"( *)(```+|~~~+)(.*)$")
COMPILE = [
    os.environ.get("CXX", "g++"),
    "-std=c++20",
    "-fsyntax-only",
    "-Wall",
    "-Wextra",
    "-Werror",
    "-Wno-missing-field-initializers",
    "-I",
    ROOT / "include",
    "-x",
    "c++",
]


@dataclass
class Block:
    page: str
    line: int  # of its first fence
    language: str
    text: str
    mark: tuple  # ("file" or "excerpt", PATH), or None

    @property
    def lines(self):
        return self.text.split("\n")


def blocks_of(page):
    """All fenced blocks of a page."""
    mark, start, fence, language, lines = None, 0, None, "", []
    for number, line in lines_of(page):
        match = FENCE.match(line)
        if fence is None and match:
            indent, fence, language = match.groups()
            start, lines = number, []
        elif fence is not None and match and match[2] == fence and not match[3]:
            yield Block(page, start, language.strip(), "\n".join(lines) + "\n", mark)
            fence, mark = None, None
        elif fence is not None:
            lines.append(line.removeprefix(indent))
        elif line.strip():
            found = MARK.match(line.strip())
            mark = found.groups() if found else None


def first_error(output):
    """The first sentence of a tool's output that says what is wrong."""
    lines = [line.strip() for line in output.splitlines() if line.strip()] or ["fails"]
    first = next((index for index, line in enumerate(lines) if "error" in line.lower()), 0)
    return " ".join(lines[first : first + (2 if lines[first].endswith(":") else 1)])


def run_on(command, text, suffix):
    """What the command says against a file of this text; nothing if it takes it."""
    with tempfile.NamedTemporaryFile("w", suffix=suffix, encoding="utf-8") as file:
        file.write(text)
        file.flush()
        run = subprocess.run([*command, file.name], capture_output=True, text=True, timeout=300)
        return None if run.returncode == 0 else first_error(run.stderr).replace(file.name, "block")


def stripped(lines):
    return [line.strip() for line in lines if line.strip()]


def fault_of_marked(block):
    kind, path = block.mark
    if not (ROOT / path).exists():
        return f"{path} does not exist"
    text = (ROOT / path).read_text(encoding="utf-8")
    if kind == "file":
        return None if text.strip() == block.text.strip() else f"the block differs from {path}"
    whole, part = stripped(text.split("\n")), stripped(block.lines)
    is_part = any(whole[i : i + len(part)] == part for i in range(len(whole)))
    return None if part and is_part else f"the block is no part of {path}"


def fault_of_cpp(block):
    return run_on(COMPILE, block.text, ".cpp")


def fault_of_sh(block):
    return run_on(["bash", "-n"], block.text, ".sh")


def fault_of_cmake(block):
    # The body of a function is parsed and not run.
    return run_on(
        ["cmake", "-P"], f"function(checked_block)\n{block.text}\nendfunction()\n", ".cmake"
    )


def fault_of_python(block):
    try:
        compile(block.text, "block", "exec")
    except SyntaxError as error:
        return str(error)
    return None


def fault_of_json(block):
    try:
        json.loads(block.text)
    except ValueError as error:
        return str(error)
    return None


def fault_of_text(block):
    if re.search(
        r"#include|coppice::|^\s*(?:\$ )?(?:coppice|cmake|make|tools/\w+) \S",
        block.text,
        re.MULTILINE,
    ):
        return "C++ and command lines are not `text`: say `cpp` or `sh`, so that they are checked"
    return None


CHECKS = {
    "cpp": fault_of_cpp,
    "sh": fault_of_sh,
    "cmake": fault_of_cmake,
    "python": fault_of_python,
    "json": fault_of_json,
    "text": fault_of_text,
}


def fault_of(block):
    """What is wrong with a block, in words, or None."""
    if block.mark:
        return fault_of_marked(block)
    if block.language not in CHECKS:
        return f"a block in '{block.language}': name one of {', '.join(CHECKS)}"
    return CHECKS[block.language](block)


def check_code_blocks(pages, offences):
    blocks = [block for page in pages for block in blocks_of(page)]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for block, fault in zip(blocks, pool.map(fault_of, blocks)):
            if fault:
                offences.add(block.page, block.line, fault)


def command_lines(block):
    """`coppice VERB ...` in a block of shell: (line, words behind coppice), continued lines joined."""
    text = re.sub(r"\\\n", lambda _: " \0", block.text)
    for number, line in enumerate(text.split("\n")):
        line_number = block.line + 1 + number + text[: text.find(line)].count("\0")
        for command in re.split(r"\||&&|;|#.*", line.replace("\0", "")):
            match = re.search(r"(?:^|[\s/(])coppice ([a-z].*)", command)
            if match:
                yield line_number, match[1].split()


def commands_in_prose(page):
    """`coppice VERB ...` in backticks, in text and tables: (line, words behind coppice)."""
    for number, line in lines_of(page):
        for command in re.findall(r"`coppice ([a-z][^`]*)`", line):
            yield number, command.split()


def check_command_lines(pages, options_of, offences):
    """Verbs and options in examples exist; `options_of` is {verb: its options}."""
    for page in pages:
        commands = list(commands_in_prose(page))
        for block in blocks_of(page):
            commands += command_lines(block) if block.language == "sh" else []
        for line, (verb, *words) in commands:
            given = {word.partition("=")[0] for word in words if word.startswith("--")}
            if verb not in options_of:
                offences.add(page, line, f"coppice has no verb '{verb}'")
            for option in sorted(given - options_of.get(verb, given) - {"--help", "--"}):
                offences.add(page, line, f"{option} is not an option of `coppice {verb}`")
