"""Finds the figures of a document by their marks, and writes them anew.

    <!-- figures: NAME ARGUMENT... -->      the lines up to <!-- end --> are a table, or lines of text
    <!-- figure: NAME ARGUMENT... -->52<!-- / -->      one figure within a sentence

Markdown shows no comments. But a line that begins with a comment is taken as it stands, without its links: so no line begins with
a figure.
"""

import re
import shlex

from results import NotMeasured

BLOCK = re.compile(r"^<!-- figures: (.+?) -->\n(.*?)^<!-- end -->$", re.S | re.M)
INLINE = re.compile(r"<!-- figure: ([^\n]+?) -->(.*?)<!-- / -->", re.S)
MARK = re.compile(r"<!-- (?:figures?: .*?|end|/) -->")
NOT_YET = "not measured yet"


class Wrong(Exception):
    """A mark that cannot be read, with its line."""


def line_of(text, place):
    return text[:place].count("\n") + 1


def call(figures, results, words, missing):
    """The lines or the text that a mark stands for."""
    name, *arguments = shlex.split(words)
    if name not in figures:
        raise Wrong(f"unknown figure '{name}', expected one of {', '.join(sorted(figures))}")
    try:
        return figures[name](results, *arguments)
    except NotMeasured as absent:
        missing.append(f"{words}: {absent}")
        return None
    except TypeError as error:
        raise Wrong(f"the figure '{words}' cannot be made: {error}") from error


def rewritten(text, figures, results, missing):
    """The document with its figures as the tables have them now. missing: gets a line for each figure without a table."""

    def block(match):
        lines = guarded(match, lambda: call(figures, results, match.group(1), missing))
        if isinstance(lines, str):
            lines = [lines]
        body = "\n".join(lines) if lines is not None else f"*{NOT_YET.capitalize()}.*"
        return f"<!-- figures: {match.group(1)} -->\n{body}\n<!-- end -->"

    def inline(match):
        value = guarded(match, lambda: call(figures, results, match.group(1), missing))
        if isinstance(value, list):
            raise Wrong(f"line {line_of(text, match.start())}: '{match.group(1)}' is a table, expected a figure")
        return f"<!-- figure: {match.group(1)} -->{NOT_YET if value is None else value}<!-- / -->"

    def guarded(match, make):
        try:
            return make()
        except Wrong as error:
            raise Wrong(f"line {line_of(text, match.start())}: {error}") from error

    refuse_faulty_marks(text)
    return INLINE.sub(inline, BLOCK.sub(block, text))


def refuse_faulty_marks(text):
    at_start = re.search(r"^\s*(?:[-*] |\d+\. )?\s*<!-- figure: ", text, re.M)
    if at_start:
        raise Wrong(f"line {line_of(text, at_start.end())}: begins with a figure, which Markdown would take for a comment of its own")
    without = INLINE.sub(lambda match: "\n" * match.group(0).count("\n"), BLOCK.sub(lambda match: "\n" * match.group(0).count("\n"), text))
    alone = MARK.search(without)
    if alone:
        raise Wrong(f"line {line_of(without, alone.start())}: '{alone.group(0)}' has no partner")


def without_figures(text):
    """The text that people write: figures, code and addresses are left out, line numbers stay."""

    def blank(match):
        return re.sub(r"[^\n]", " ", match.group(0))

    for pattern in (BLOCK, INLINE, re.compile(r"^```.*?^```", re.S | re.M), re.compile(r"<!--.*?-->", re.S), re.compile(r"`[^`]*`"),
                    re.compile(r"\]\([^)]*\)")):
        text = pattern.sub(blank, text)
    return text
