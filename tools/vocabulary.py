"""Words that this project has given up, and what to say instead; for tools/check_docs.

One entry is (pattern, say instead). Patterns are precise enough that plain English passes: "white at the
horizon" is no `Horizon`, "a group of people" no ray packet. Case counts.
"""

import re
import subprocess

from project import ROOT, lines_of

RETIRED = [
    # Trees and their tracing.
    (
        r"\bWide(?:Bvh|Tracer|Node|Child|Options|Preset|Builder)\w*",
        "Bvh8, Bvh8Tracer, Bvh8Node, ...",
    ),
    (
        r"\b\w*wide_(?:bvh|tracer|node|child|width|preset|options|reference)\w*",
        "bvh8, bvh8_tracer, ...",
    ),
    (r"(?<!8-)\b[Ww]ide (?:trees?|nodes?|BVHs?|references?|methods?)\b", "8-wide tree, Bvh8"),
    (r"\b(?:Quick|Careful)Ray\b", "fast and robust traversal"),
    (r"\bFirstHit\b|\bAllHits\b", "ClosestHitQuery, AnyHitQuery, FirstKHitsQuery"),
    (r"\bGroupTraversal\b|\b[Rr]ay groups?\b|\bgroups? of rays\b", "ray packet"),
    (r"\b[Bb]eams?\b", "frustum of a packet"),
    # Builders.
    (
        r"\bFragment\b|\bFragmentStack\b|\bfragment_stack\b|\bfragments\b",
        "PrimRef, primitive reference",
    ),
    (r"\bHorizon\b|\bhorizon\.h\b|\bhorizon_\w+", "TopTree"),
    (r"\bSender\b", "TopTree"),
    (r"\bStop::|\benum class Stop\b|\bStopRule\b|\bstop_rule\b", "Termination"),
    (r"\bCounting::|\benum class Counting\b", "SampleWeighting"),
    (r"\bGrowth::|\benum class Growth\b", "LeafRefinement"),
    (r"\bArena\b", "DoubleBuffer"),
    (r"\b[Ss]top[ _-]looks?\b|\bStopLook\b", "cancellation, CancellationPoll"),
    (r"\.(?:growth|counting)\b(?!\()", "leaf_refinement, sample_weighting"),
    (
        r"^(?:struct|class|enum class) (?:Stop|Split|Plane|Finding|Estimate)\b",
        "Termination, SplitCandidate, SplitPlane, ValidationIssue, BuildEstimate",
    ),
    # Arithmetic and files.
    (r"\b[Tt]wofolds?\b", "double-double"),
    (r"\bexact[ _]sums?\b|\bExactSum\b", "expansion"),
    (r"\b[Ee]dge[ _]volumes?\b|\bEdgeVolume\w*", "edge function"),
    (r"\b[Oo]ddit(?:y|ies)\b", "LoadIssue, load issue"),
    # Folders.
    (
        r"\bworkbench/lab\b|\btests/lab\b|#include \"lab/",
        "statistics, rows, scenes, experiment, bench, verify, tune, compare",
    ),
    (r"\bcoppice/build/|\b(?:src|tests)/build/(?=\w)", "builders/"),
]

# What tells of the past, and this table.
EXEMPT = {"CHANGELOG.md", "tools/vocabulary.py"}
SUFFIXES = (
    ".h",
    ".cpp",
    ".inl",
    ".md",
    ".py",
    ".sh",
    ".txt",
    ".cmake",
    ".mjs",
    ".js",
    ".css",
    ".html",
    ".in",
    "",
)


def checked_files():
    """All text that is written by hand, relative to the root."""
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT,
        check=True,
        capture_output=True,
        text=True,
    ).stdout
    for name in sorted(set(listed.split("\0")) - {""} - EXEMPT):
        path = ROOT / name
        if (
            path.is_file()
            and path.suffix in SUFFIXES
            and not name.startswith(("tests/data/", "tests/repro/", "fuzz/seeds"))
        ):
            yield name


def check_vocabulary(offences):
    retired = [(re.compile(pattern), better) for pattern, better in RETIRED]
    for name in checked_files():
        try:
            lines = list(lines_of(name))
        except UnicodeDecodeError:
            continue  # no text
        for number, line in lines:
            for pattern, better in retired:
                if match := pattern.search(line):
                    offences.add(name, number, f"'{match[0]}' is a retired word: say {better}")
