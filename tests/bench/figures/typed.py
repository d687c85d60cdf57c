"""Finds measured figures that somebody typed into a document in place of a mark.

A number with a unit of time, a factor, a share or a memory size counts as measured, unless it is listed below as what it is: a setting of
a measurement, a definition, or a number that others published.
"""

import re

from marks import without_figures

UNIT = r"(?:us|ms|s|seconds?|microseconds?|milliseconds?|minutes?|hours?|times|%|GB|MB|bytes|digits)"
NUMBER = re.compile(rf"(?<![\w.^-])-?\d[\d.,]*(?:e-?\d+)?(?: (?:to|and|or) -?\d[\d.,]*(?:e-?\d+)?)?\s{UNIT}(?![\w-])")

# Documents without typed figures, with the numbers of this form that they may hold.
DOCUMENTS = {
    "README.md": (),
    "docs/accuracy.md": ("1 %",),  # OMPL's default resolution
    "docs/benchmarks.md": ("60 s", "300 s"),  # limits of time
    "docs/engine_benchmarks.md": ("0.38 ms",),  # what gDist states
    "docs/leaf_strategies.md": (),
    "docs/leaf_strategies_tables.md": ("95 %", "2 %", "5 %", "10 %"),  # how the study judges
    "docs/public_problems.md": ("2,171 s", "2,550 s", "1 %", "60 s", "20 s"),  # others' figures; OMPL.app's resolution; limits of time
    "docs/scenes.md": ("1.5 times",),  # what "tight" means
}


def typed_figures(name, text):
    """The lines of a document, with what is typed there; each listed number must be there."""
    if name not in DOCUMENTS:
        return []
    listed = set(DOCUMENTS[name])
    found = [(text[:match.start()].count("\n") + 1, " ".join(match.group(0).split())) for match in NUMBER.finditer(without_figures(text))]
    faults = [(line, f"'{words}' is typed: expected a figure's mark, or its line in typed.py") for line, words in found if words not in listed]
    return faults + [(1, f"typed.py lists '{words}', which the document does not hold") for words in sorted(listed - {words for _, words in found})]
