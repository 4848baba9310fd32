"""Finds what a shared library must offer: declarations in public headers that are defined in src/."""

import re

COMMENT = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|^[ \t]*#(?:\\\n|[^\n])*', re.S | re.M)
CLASS = re.compile(r"^(?:template\s*<.*>\s*)?(class|struct|union)\s+(?:\[\[.*?\]\]\s*|COPPICE_EXPORT\s+)*(\w+)", re.S)
NOTHING_TO_LINK = re.compile(
    r"^(template|using|typedef|friend|static_assert|enum|(class|struct|union)\s+\w+\s*;|namespace|concept)\b"
    r"|\b(inline|constexpr|consteval)\b|=\s*(default|delete|0)\s*;$")  # fmt: skip


def blanked(text):
    """The text with comments, literals and preprocessor lines as spaces, at the same places."""
    return COMMENT.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), text)


def end_of_braces(code, begin):
    depth = 0
    for at in range(begin, len(code)):
        depth += {"{": 1, "}": -1}.get(code[at], 0)
        if depth == 0:
            return at
    raise ValueError("braces do not match")


def statements(code, begin, end):
    """(begin, head, body) of each declaration in a scope; body is its (begin, end) or None."""
    start = at = begin
    while at < end:
        if code[at] == ";":
            yield start, code[start : at + 1], None
            start = at + 1
        elif code[at] == "(":
            at = end_of_parentheses(code, at)
        elif code[at] == "{":
            close = end_of_braces(code, at)
            head = code[start:at]
            yield start, head, (at + 1, close)
            at = close
            # What follows a function's body is the next declaration; a class goes on to its `;`.
            start = code.index(";", close) + 1 if needs_semicolon(head) else close + 1
            at = start - 1
        at += 1


def end_of_parentheses(code, begin):
    depth = 0
    for at in range(begin, len(code)):
        depth += {"(": 1, ")": -1}.get(code[at], 0)
        if depth == 0:
            return at
    raise ValueError("parentheses do not match")


def needs_semicolon(head):
    head = head.strip()
    if re.match(r"(inline\s+)?namespace\b", head):
        return False
    return bool(CLASS.match(head) or head.startswith("enum")) or head.endswith("=") or "(" not in head


def without_access(head):
    return re.sub(r"^\s*(?:(?:public|protected|private)\s*:\s*)*", "", head)


def is_defined_elsewhere(head):
    """True for the declaration of a function or variable that has its definition in a source."""
    head = without_access(head).strip()
    if not head.endswith(";") or head == ";" or NOTHING_TO_LINK.search(head):
        return False
    return "(" in head or re.match(r"(static|extern)\b", head) is not None


def class_needs_export(code, body):
    for _, head, inner in statements(code, *body):
        is_class = CLASS.match(without_access(head).strip())
        if inner is None and is_defined_elsewhere(head) and not is_data_member(head):
            return True
        if inner is not None and is_class and not head.strip().startswith("template") and class_needs_export(code, inner):
            return True
    return False


def is_data_member(head):
    """`std::function<void(int)> work;`, `double most = max();` and `int (*call)(int);` are, too."""
    flat = re.sub(r"\boperator\s*[^\w\s(]+", "operator", without_access(head))
    if re.search(r"\(\s*\*", flat):
        return True
    flat = flat.split("=")[0] if "(" not in flat.split("=")[0] else flat
    while (shorter := re.sub(r"<[^<>]*>", "", flat)) != flat:
        flat = shorter
    return "(" not in flat and not re.match(r"\s*static\b(?!.*\b(inline|constexpr)\b)", flat)


def missing(text):
    """Places in a header where COPPICE_EXPORT is missing: (offset to put it, name of what is there)."""
    code = blanked(text)
    yield from missing_in(code, 0, len(code))


def missing_in(code, begin, end):
    for start, head, body in statements(code, begin, end):
        stripped = head.strip()
        place = start + len(head) - len(head.lstrip())
        if re.match(r"(inline\s+)?namespace\b", stripped):
            yield from missing_in(code, *body)
        elif "COPPICE_EXPORT" in stripped:
            continue
        elif body is not None:
            match = CLASS.match(stripped)
            if match and not stripped.startswith("template") and class_needs_export(code, body):
                yield place + match.start(1) + len(match.group(1)) + 1, match.group(2)
        elif is_defined_elsewhere(head) and not is_data_member(head):
            attributes = re.match(r"(\[\[.*?\]\]\s*)?(extern\s+)?", stripped, re.S).end()
            yield place + attributes, " ".join(stripped.split())
