"""From the Markdown of the repository to that of the site, for tools/build_docs.

Pages are written for a forge and for the site alike. What only the site has is made here:

  sidebar     index.md and the README.md of a folder list pages by links; each list becomes a
              toctree, in index.md under the heading above it
  links       to a page of the site stay links to it; to another file of the repository they become
              downloads; to a folder they become its name
  [Key]       has an anchor in references.md; docs/site/conf.py links to it
  glossary    the items `- **term**: definition` of glossary.md become a glossary that is indexed
  reference   `<!-- api: MODULE -->` becomes what the headers in include/coppice/MODULE declare
"""

import os
import re

from project import ROOT

# Pages outside docs/, and what they are called in the site.
OUTER_PAGES = {
    "CHANGELOG.md": "changelog.md",
    "CONTRIBUTING.md": "contributing.md",
    "src/README.md": "source_tour.md",
}
HOME = "README.md"  # of the repository: the site has index.md for it

HEADERS = "include/coppice"
API_MARK = re.compile(r"^<!-- api: (\S+) -->$", re.MULTILINE)
LINK = re.compile(r"(!?)\[((?:[^][]|\[[^]]*\])*)\]\(<?([^)\s>]+)>?\)")


def site_names():
    """{path in the repository: path in the site} of all pages and images."""
    docs = [path.relative_to(ROOT) for path in (ROOT / "docs").rglob("*") if path.is_file()]
    names = {
        str(path): str(path.relative_to("docs")).replace("README.md", "index.md")
        for path in docs
        if path.suffix in {".md", ".svg", ".png", ".jpg"} and path.parts[1] != "site"
    }
    return names | {page: name for page, name in OUTER_PAGES.items() if (ROOT / page).exists()}


def outside_fences(text, change):
    """The text with `change(part)` in place of every part that is in no fenced block."""
    parts = re.split(r"(^ *```.*?^ *```$)", text, flags=re.DOTALL | re.MULTILINE)
    return "".join(part if index % 2 else change(part) for index, part in enumerate(parts))


def relative(target, page_name):
    return os.path.relpath(target, os.path.dirname(page_name) or ".")


def rewrite_links(text, page, names, source):
    """Links as the site needs them; `source` is the folder that its pages are put into."""
    here = os.path.dirname(page)

    def rewrite(match):
        mark, label, link = match.groups()
        path, _, anchor = link.partition("#")
        if re.match(r"[a-z]+:", link) or not path:
            return match[0]
        target = os.path.normpath(os.path.join(here, path))
        name = "index.md" if target == HOME else names.get(target)
        if name:
            link = relative(name, names[page]) + ("#" + anchor if anchor else "")
        elif (ROOT / target).is_dir():
            return label
        else:
            link = os.path.relpath(ROOT / target, os.path.dirname(source / names[page]))
        return f"{mark}[{label}]({link})"

    return outside_fences(text, lambda part: LINK.sub(rewrite, part))


def with_targets(text):
    """references.md with an anchor before every entry."""
    return re.sub(
        r"^- \*\*\[(\w+)\]\*\*",
        lambda m: f"\n(ref-{m[1].lower()})=\n**{m[1]}**",
        text,
        flags=re.MULTILINE,
    )


def with_glossary(text):
    """glossary.md with every run of items in a glossary directive."""
    item = re.compile(r"^- ((?:\*\*[^*]+\*\*(?:, )?)+): (.*(?:\n  .*)*)\n", re.MULTILINE)

    def directive(run):
        terms = []
        for names, definition in item.findall(run[0]):
            terms += re.findall(r"\*\*([^*]+)\*\*", names)
            terms += ["  " + line.strip() for line in definition.split("\n")] + [""]
        return "```{glossary}\n" + "\n".join(terms) + "```\n"

    return re.sub(rf"(?:{item.pattern})+", directive, text, flags=re.MULTILINE)


def with_sidebar(text, page):
    """A page that lists others, with their toctrees: one under every heading of index.md."""
    listed = re.compile(r"^(?:[-*]|\|) *\[[^]]*\]\(([^)#]+)\.md\)", re.MULTILINE)
    is_home = page == "docs/index.md"
    seen, trees = set(), []
    for section in re.split(r"^## ", text, flags=re.MULTILINE):
        entries = [name for name in listed.findall(section) if not (name in seen or seen.add(name))]
        if entries:
            caption = [":caption: " + section.split("\n")[0]] if is_home else []
            trees.append("\n".join(["```{toctree}", ":hidden:", *caption, "", *entries, "```"]))
    return text + "\n" + "\n\n".join(trees) + "\n"


def headers_of(module):
    """The headers of a folder below include/coppice, those of its own folders last; `.`: its own."""
    folder = ROOT / HEADERS / module
    found = folder.glob("*.h") if module == "." else folder.rglob("*.h")
    return sorted(
        (path.relative_to(ROOT / "include") for path in found), key=lambda p: (len(p.parts), p)
    )


def with_reference(text, declared):
    def expand(match):
        headers = [str(header) for header in headers_of(match[1])]
        return "\n\n".join(
            "\n\n".join([f"## {os.path.basename(header)}", *declared[header]])
            for header in headers
            if header in declared
        )

    return API_MARK.sub(expand, text)


MAKE = {"docs/references.md": with_targets, "docs/glossary.md": with_glossary}


def check_reference(pages):
    """Every folder of public headers has its page, and no page speaks of a folder that is gone."""
    wanted = {path.name for path in (ROOT / HEADERS).iterdir() if path.is_dir()} - {"detail"} | {
        "."
    }
    found = [module for text in pages.values() for module in API_MARK.findall(text)]
    for module in sorted(wanted - set(found)):
        raise SystemExit(
            f"coppice build_docs: the headers in {HEADERS}/{module} are on no page: "
            f"write docs/api/{module}.md with the line <!-- api: {module} -->, and list it in README.md there"
        )
    for module in sorted(set(found) - wanted):
        raise SystemExit(
            f"coppice build_docs: a page in docs/api has <!-- api: {module} -->; there is no {HEADERS}/{module}"
        )


def write_if_changed(path, contents):
    """So that Sphinx reads again only what is new."""
    if not path.exists() or path.read_bytes() != contents:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(contents)


def stage_pages(source, declared):
    """Puts all pages of the site into a folder and removes what is not of it.

    `declared` has the directives of each public header, see site_reference.
    """
    names = site_names()
    pages = {
        page: (ROOT / page).read_text(encoding="utf-8") for page in names if page.endswith(".md")
    }
    check_reference(pages)
    for page, text in pages.items():
        text = rewrite_links(text, page, names, source)
        if os.path.basename(names[page]) == "index.md":
            text = with_sidebar(text, page)
        text = MAKE.get(page, lambda same: same)(text)
        text = with_reference(text, declared)
        write_if_changed(source / names[page], text.encode())
    for image in names.keys() - pages.keys():
        write_if_changed(source / names[image], (ROOT / image).read_bytes())
    for old in source.rglob("*"):
        if old.is_file() and str(old.relative_to(source)) not in names.values():
            old.unlink()
