"""Reads a Markdown document as far as the tests of documents need it: headings, links, inline code, blocks of code."""

import re
import urllib.parse
from dataclasses import dataclass, field


@dataclass
class Block:
    """A fenced block of code, or an indented one (language "indented")."""

    language: str
    text: str
    line: int  # of its first line of code
    directives: list = field(default_factory=list)  # (line, text) of each `test:` comment before it


@dataclass
class Document:
    name: str  # its path below the repository's root
    blocks: list = field(default_factory=list)
    links: list = field(default_factory=list)  # (line, target)
    spans: list = field(default_factory=list)  # (line, text) of inline code
    anchors: set = field(default_factory=set)
    tables: list = field(default_factory=list)  # (line, directives, rows of cells)
    stray: list = field(default_factory=list)  # directives that stand before no block and no table


def anchor_of(heading):
    """The anchor that GitHub gives a heading."""
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "")
    return re.sub(r"[^\w\- ]", "", text.strip().lower()).replace(" ", "-")


class Reader:
    def __init__(self, name, text):
        self.document = Document(name)
        self.lines = text.split("\n")
        self.pending = []  # directives that wait for their block
        self.prose = []  # (line, text) of lines that may hold links and inline code

    def read(self):
        at = 0
        while at < len(self.lines):
            at = self.take(at)
        self.document.stray += self.pending
        self.read_prose()
        return self.document

    def take(self, at):
        """Reads what begins at a line; returns the line after it."""
        line = self.lines[at]
        fence = re.match(r"( *)(`{3,}|~{3,})\s*(\S*)\s*$", line)
        if line.lstrip().startswith("<!--"):
            return self.comment(at)
        if fence:
            return self.fenced(at, fence)
        if re.match(r"(    |\t)\S", line) and (at == 0 or not self.lines[at - 1].strip()) and not self.in_list(at):
            return self.indented(at)
        if line.lstrip().startswith("|"):
            return self.table(at)
        heading = re.match(r"#{1,6}\s+(.*?)\s*#*$", line)
        if heading:
            self.heading(heading.group(1))
        if line.strip():
            self.document.stray += self.pending
            self.pending = []
        self.prose.append((at + 1, line))
        return at + 1

    def in_list(self, at):
        """True for a paragraph that goes on with a list's item."""
        for line in reversed(self.lines[:at]):
            if line.strip() and not line.startswith(" "):
                return re.match(r"([-*]|\d+\.)\s", line) is not None
        return False

    def heading(self, text):
        anchor = anchor_of(text)
        numbered, count = anchor, 0
        while numbered in self.document.anchors:
            count += 1
            numbered = f"{anchor}-{count}"
        self.document.anchors.add(numbered)

    def comment(self, at):
        end = at
        while "-->" not in self.lines[end] and end + 1 < len(self.lines):
            end += 1
        text = "\n".join(self.lines[at : end + 1])
        directive = re.match(r"\s*<!--\s*test:\s*(.*?)\s*-->", text, re.S)
        if directive:
            self.pending.append((at + 1, directive.group(1)))
        return end + 1

    def add_block(self, language, lines, first):
        self.document.blocks.append(Block(language, "\n".join(lines) + "\n", first + 1, self.pending))
        self.pending = []

    def fenced(self, at, fence):
        indent, marks, language = fence.groups()
        end = at + 1
        while end < len(self.lines) and not re.match(r" *" + re.escape(marks) + r"+\s*$", self.lines[end]):
            end += 1
        body = [line[len(indent) :] if line.startswith(indent) else line for line in self.lines[at + 1 : end]]
        self.add_block(language or "text", body, at + 1)
        return end + 1

    def indented(self, at):
        end = at
        while end < len(self.lines) and (re.match(r"(    |\t)", self.lines[end]) or not self.lines[end].strip()):
            end += 1
        while not self.lines[end - 1].strip():
            end -= 1
        self.add_block("indented", [line[4:] for line in self.lines[at:end]], at)
        return end

    def table(self, at):
        end = at
        while end < len(self.lines) and self.lines[end].lstrip().startswith("|"):
            self.prose += [(end + 1, self.lines[end]), (end + 1, "")]
            end += 1
        rows = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in self.lines[at:end]]
        self.document.tables.append((at + 1, self.pending, rows))
        self.pending = []
        return end

    def read_prose(self):
        """Links and inline code may go on over the end of a line, but not over an empty one."""
        paragraph = []
        for line, text in self.prose + [(0, "")]:
            if text.strip():
                paragraph.append((line, text))
            elif paragraph:
                self.read_paragraph(paragraph)
                paragraph = []

    def read_paragraph(self, paragraph):
        text = "\n".join(line for _, line in paragraph)

        def line_at(place):
            return paragraph[text[:place].count("\n")][0]

        for code in re.finditer(r"(`+)(.+?)\1", text, re.S):
            self.document.spans.append((line_at(code.start()), " ".join(code.group(2).split())))
        bare = re.sub(r"(`+)(.+?)\1", lambda code: re.sub(r"[^\n]", "x", code.group(0)), text, flags=re.S)
        for link in re.finditer(r"\[[^\[\]]*\]\(\s*<?([^)\s>]*)>?(?:\s+\"[^\"]*\")?\s*\)", bare):
            self.document.links.append((line_at(link.start()), urllib.parse.unquote(link.group(1))))
        for link in re.finditer(r"<(https?://[^>\s]*)>", bare):
            self.document.links.append((line_at(link.start()), link.group(1)))


def read_document(root, name):
    return Reader(name, (root / name).read_text(encoding="utf-8")).read()
