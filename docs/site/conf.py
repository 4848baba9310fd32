"""How Sphinx makes the site; tools/build_docs prepares the pages and calls it."""

import os
import re
from pathlib import Path

from docutils import nodes
from sphinx import addnodes

ROOT = Path(__file__).resolve().parents[2]


def project_version():
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(coppice VERSION ([\d.]+)", text)[1]


project = "coppice"
author = "the coppice authors"
copyright = author
version = release = project_version()

extensions = ["myst_parser", "breathe"]
myst_heading_anchors = 4  # the anchors that forges give headings
highlight_language = "none"
primary_domain = "cpp"

breathe_projects = {"coppice": os.environ["COPPICE_DOXYGEN_XML"]}
breathe_default_project = "coppice"
cpp_id_attributes = ["COPPICE_EXPORT"]

html_theme = "furo"
html_title = f"coppice {version}"
html_static_path = [str(Path(__file__).parent / "static")]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#2f6b3a", "color-brand-content": "#2f6b3a"},
    "dark_css_variables": {"color-brand-primary": "#8fca98", "color-brand-content": "#8fca98"},
}

CITATION = re.compile(r"(\[[A-Z]\w+\d{4}\])")


def link_citations(app, document):
    """[Key] becomes a link to its entry in references.md, in pages and in comments of headers."""
    if app.env.docname == "references":
        return
    for text in list(document.findall(nodes.Text)):
        if CITATION.search(text) and not isinstance(
            text.parent, (nodes.literal, nodes.literal_block, nodes.reference)
        ):
            parts = [part for part in CITATION.split(text) if part]
            text.parent.replace(
                text,
                [
                    link_to(app.env.docname, part) if CITATION.match(part) else nodes.Text(part)
                    for part in parts
                ],
            )


def link_to(page, key):
    link = addnodes.pending_xref(
        key,
        nodes.inline(key, key),
        refdomain="std",
        reftype="ref",
        refexplicit=True,
        refwarn=True,
        reftarget="ref-" + key[1:-1].lower(),
        refdoc=page,
    )
    link.source, link.line = page, 0
    return link


def setup(app):
    app.connect("doctree-read", link_citations)
