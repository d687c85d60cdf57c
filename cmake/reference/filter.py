#!/usr/bin/env python3
"""filter.py FILE: prints a header or a guide in the form that Doxygen understands. Lines keep their numbers.

A header's first comment becomes the description of the file. A guide's headings get the anchors that GitHub gives them, links between
guides and to headers become references, and links to other files, which the reference does not hold, become their text.
"""

import os
import re
import sys

LINK = re.compile(r"`[^`]*`|(?<!!)\[(?P<shown>(?:`[^`]*`|[^\[\]`])*)\]\((?P<target>[^)\s]*)\)")


def header(path, text):
    name = path.rsplit("/include/", 1)[1]
    first, rest = re.match(r"((?://.*\n)*)(.*)", text, re.S).groups()
    return re.sub(r"^///? ?", "/// ", first, flags=re.M).replace("/// ", f"/// @file {name} ", 1) + rest


def page_of(path):
    return re.sub(r"\W", "_", os.path.basename(path).removesuffix(".md"))


def anchor_of(heading):
    """The anchor that GitHub gives a heading."""
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "")
    return re.sub(r"[^\w\- ]", "", text.strip().lower()).replace(" ", "-")


def heading(page, marks, text):
    if page == "reference" and marks == "#":
        text = "clearway"  # a landing page of another title than the project's has no guides below it in Doxygen's tree
    shown = text.replace("`", "")  # Doxygen shows the marks of code within headings
    return f"{marks} {shown} {{#{page if marks == '#' else page + '_' + anchor_of(text)}}}"


def link(folder, page, shown, target):
    shown = shown.replace("`", "")  # Doxygen shows these marks within a link
    path, _, anchor = target.partition("#")
    file = os.path.normpath(os.path.join(folder, path))
    if "://" in target:
        return f"[{shown}]({target})"
    if page == "reference" and os.path.dirname(file) == folder and path.endswith(".md"):
        return f'@subpage {page_of(path)} "{shown}"'  # the landing page orders the guides
    if not path or os.path.dirname(file) == folder and path.endswith(".md"):
        page = page_of(path) if path else page
        return f"[{shown}](@ref {page + '_' + anchor if anchor else page})"
    if "/include/" in file and file.endswith((".h", ".h.in")):
        return f"[{shown}](@ref {file.rsplit('/include/', 1)[1].removesuffix('.in')})"
    return shown


def guide(path, text):
    folder, page = os.path.dirname(path), page_of(path)
    text = re.sub(r"^<!--.*?-->", lambda comment: "\n" * comment.group().count("\n"), text, flags=re.S | re.M)
    pieces = re.split(r"(^ *```.*?^ *```$)", text, flags=re.S | re.M)  # blocks of code stand at odd places
    for at in range(0, len(pieces), 2):
        text = LINK.sub(lambda found: link(folder, page, *found.groups()) if found["target"] else found[0], pieces[at])
        pieces[at] = re.sub(r"^(#+) (.*)$", lambda found: heading(page, *found.groups()), text, flags=re.M)
    return "".join(pieces)


if __name__ == "__main__":
    path = os.path.abspath(sys.argv[1])
    with open(path, encoding="utf-8") as file:
        sys.stdout.write((guide if path.endswith(".md") else header)(path, file.read()))
