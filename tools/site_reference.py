"""What each public header declares, in its order, as directives of Breathe; for tools/build_docs."""

import xml.etree.ElementTree as ElementTree
from collections import defaultdict

DIRECTIVE = {
    "class": "doxygenclass",
    "struct": "doxygenstruct",
    "union": "doxygenunion",
    "concept": "doxygenconcept",
    "function": "doxygenfunction",
    "enum": "doxygenenum",
    "typedef": "doxygentypedef",
    "variable": "doxygenvariable",
    "define": "doxygendefine",
}
MEMBERS = {
    "doxygenclass": ":members:\n:undoc-members:",
    "doxygenstruct": ":members:\n:undoc-members:",
}


def text_of(element, tag):
    found = element.find(tag)
    return "" if found is None else "".join(found.itertext()).strip()


def directive_for(kind, name, arguments=""):
    directive = DIRECTIVE[kind]
    options = MEMBERS.get(directive, "")
    return f"```{{{directive}}} {name}{arguments}\n{options}\n```"


def compounds(folder):
    """All compounds of Doxygen's XML: namespaces, classes, files ..."""
    for path in sorted(folder.glob("*.xml")):
        if path.name not in ("index.xml", "Doxyfile.xml"):
            yield from ElementTree.parse(path).getroot().iter("compounddef")


def declarations(folder):
    """{header as it is included: [directive, ...]} of all that stands at namespace level."""
    found = defaultdict(list)  # of (line, directive)
    trees = list(compounds(folder))
    spaces = {
        text_of(compound, "compoundname")
        for compound in trees
        if compound.get("kind") == "namespace"
    }

    def add(element, kind, name, arguments=""):
        location = element.find("location")
        header = location.get("declfile") or location.get("file")
        line = location.get("declline") or location.get("line")
        found[header].append((int(line), directive_for(kind, name, arguments)))

    for compound in trees:
        kind, name = compound.get("kind"), text_of(compound, "compoundname")
        if kind in ("namespace", "file"):
            for member in compound.iter("memberdef"):
                if kind == "namespace" or member.get("kind") == "define":
                    space = name + "::" if kind == "namespace" else ""
                    add(
                        member,
                        member.get("kind"),
                        space + text_of(member, "name"),
                        text_of(member, "argsstring") if member.get("kind") == "function" else "",
                    )
        elif kind in DIRECTIVE and name.rpartition("::")[0] in spaces:
            add(compound, kind, name)
    return {
        header: [directive for _, directive in sorted(entries)] for header, entries in found.items()
    }
