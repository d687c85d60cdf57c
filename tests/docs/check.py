#!/usr/bin/env python3
"""Checks the repository's documents: links, pieces of code, commands.

    check.py links ROOT                      links, anchors, paths named in `code`, tables of include rules and headers
    check.py code ROOT BUILD                 compiles ```cpp and ```c blocks, configures ```cmake blocks
    check.py commands ROOT BUILD PROGRAM     runs ```sh blocks, reads ```ini blocks as problem files

BUILD is a build tree of the repository, PROGRAM its `clearway`. The environment variable CLEARWAY_FULL=1 asks for the
long form.

The blocks of one document are taken in order. Commands run in a scratch folder that holds a copy of data and
build/release/bin with the program. `clearway` is run; `./demos/run` is run in the long form alone. For cmake, ctest,
./tests/run and programs below build/dev/tests only names and options are checked. Only names and options are checked, too,
in documents other than README.md, CONTRIBUTING.md and docs/. Pieces of C++ or C without `main` make one function for each document.

HTML comments before a block state exceptions:

    <!-- test: options only -->              the commands are not run
    <!-- test: full -->                      the commands are run in the long form alone
    <!-- test: "A" becomes "B" -->           in the short form A is replaced
    <!-- test: exits with 1 -->              the block's last command ends with this exit code
    <!-- test: before CODE -->               stands before the block's code (cpp, c, cmake)
    <!-- test: file NAME -->                 the block is written to a file of the scratch folder; then
    <!-- test: file NAME begins as BASE -->  ... after the text of BASE,
    <!-- test: file NAME begins as BASE up to TEXT -->  ... or what BASE holds before TEXT
    <!-- test: prints the distance -->       tests/install runs the block among the files before it (text)
    <!-- test: layering -->                  the table repeats the include rules of tests/layering.cmake
    <!-- test: headers of FOLDER -->         the table has one row for each header of the folder
"""

import os
import pathlib
import re
import sys
import urllib.parse

sys.dont_write_bytecode = True  # the sources' folder stays as it is

from code_blocks import check_code
from commands import check_commands
from markdown import read_document

LANGUAGES = {"sh", "cpp", "c", "ini", "cmake", "python", "text", "indented"}
DIRECTIVES = re.compile(
    r'options only|full|".+?" becomes ".*"|exits with \d+|before\s.+|file \S+( begins as \S+( up to .+)?)?|prints the distance|layering|headers of \S+', re.S
)
SKIPPED_FOLDERS = {".git", "build", "out", "vendor"}


class Report:
    def __init__(self):
        self.errors = []

    def refuse(self, document, line, message):
        self.errors.append(f"{document.name}:{line}: {message}")


def documents_of(root):
    names = []
    for folder, folders, files in os.walk(root):
        folders[:] = set(folders) - SKIPPED_FOLDERS  # other tests make and remove folders in build meanwhile
        names += [(pathlib.Path(folder) / file).relative_to(root) for file in files if file.endswith(".md")]
    return [read_document(root, str(name)) for name in sorted(names)]


def check_form(document, report):
    """Refuses languages and directives that the tests do not understand, and directives that stand before nothing."""
    for line, text in document.stray:
        report.refuse(document, line, f"the directive '{text}' stands before no block of code and no table")
    for block in document.blocks:
        if block.language not in LANGUAGES:
            expected = ", ".join(sorted(LANGUAGES - {"indented"}))
            report.refuse(document, block.line, f"the block's language is '{block.language}', expected one of {expected}")
        for line, text in block.directives:
            if not DIRECTIVES.fullmatch(text):
                report.refuse(document, line, f"unknown directive '{text}'; tests/docs/check.py lists the known ones")


def check_links(root, documents, report):
    by_path = {(root / document.name).resolve(): document for document in documents}
    for document in documents:
        for line, target in document.links:
            check_link(root, document, line, target, by_path, report)


def check_link(root, document, line, target, by_path, report):
    if re.match(r"[a-z]+:", target):
        url = urllib.parse.urlparse(target)
        if url.scheme not in ("http", "https") or "." not in url.netloc:
            report.refuse(document, line, f"the link '{target}' is no address, expected https://HOST...")
        return
    path, _, anchor = target.partition("#")
    file = (root / document.name).parent / path if path else root / document.name
    if not target or not file.exists():
        report.refuse(document, line, f"the link '{target}' leads to no file")
    elif not file.resolve().is_relative_to(root.resolve()):
        report.refuse(document, line, f"the link '{target}' leads out of the repository")
    elif anchor and anchor not in getattr(by_path.get(file.resolve()), "anchors", ()):
        report.refuse(document, line, f"the link '{target}' leads to no heading of {file.name}")


def check_paths(root, documents, report):
    """A path of the repository in `code` must exist, unless the document makes the file, or the path has a placeholder in capitals."""
    for document in documents:
        made = {text.split()[1] for block in document.blocks for _, text in block.directives if text.startswith("file ")}
        made |= set(re.findall(r"--out (\S+)", "".join(block.text for block in document.blocks)))
        for line, text in document.spans:
            if not re.fullmatch(r"(src|include|tests|docs|demos|data|cmake)/[\w./+-]+", text) or re.search(r"\b[A-Z]{3,}", text):
                continue
            if document.name != "CHANGELOG.md" and text not in made and not (root / text).exists():
                report.refuse(document, line, f"`{text}` is not there")


def include_rules(root):
    """Maps each room of src to the set of rooms it may include, as tests/layering.cmake states them."""
    lists = {}
    for name, values in re.findall(r"\bset\(([\w/]+)([^)]*)\)", (root / "tests/layering.cmake").read_text()):
        expanded = []
        for value in values.split():
            variable = re.fullmatch(r"\$\{([\w/]+)\}", value)
            expanded += lists.get(variable.group(1), []) if variable else [value]
        lists.setdefault(name, expanded)
    return {name[: -len("_may_include")]: set(values) for name, values in lists.items() if name.endswith("_may_include")}


def check_tables(root, documents, report):
    for document in documents:
        for line, directives, rows in document.tables:
            for at, text in directives:
                if text == "layering":
                    check_include_table(root, document, line, rows, report)
                elif text.startswith("headers of "):
                    check_header_table(root, document, line, rows, text[len("headers of ") :], report)
                else:
                    report.refuse(document, at, f"the directive '{text}' stands before a table")


def check_include_table(root, document, line, rows, report):
    rules = include_rules(root)
    stated = {}
    for row in rows[2:]:
        (room,), names = re.findall(r"`([^`]+)`", row[0]), re.findall(r"`([^`]+)`", row[1])
        stars = {rule for rule in rules for name in names if name.endswith("*") and rule.startswith(name[:-1])}
        stated[room] = ({name for name in names if not name.endswith("*")} | stars) - {room}
    for room in sorted(rules.keys() | stated.keys()):
        if rules.get(room) != stated.get(room):
            truth = ", ".join(sorted(rules.get(room, ()))) or "no other"
            report.refuse(document, line, f"by tests/layering.cmake {room} may include {truth}; the table differs")


def check_header_table(root, document, line, rows, folder, report):
    headers = [file.name for file in (root / folder).glob("*.h*")]
    listed = re.findall(r"/([\w.]+)\)", " ".join(row[1] for row in rows[2:]))
    for header in sorted({*headers, *listed}):
        if (headers.count(header), listed.count(header)) != (1, 1):
            report.refuse(document, line, f"{folder}/{header} is there {headers.count(header)} times, in the table {listed.count(header)} times")
    if not headers:
        report.refuse(document, line, f"{folder} has no headers")


def main(arguments):
    if len(arguments) < 2 or arguments[0] not in ("links", "code", "commands"):
        sys.exit(__doc__)
    what, root = arguments[0], pathlib.Path(arguments[1]).resolve()
    documents = documents_of(root)
    report = Report()
    for document in documents:
        check_form(document, report)
    if what == "links":
        check_links(root, documents, report)
        check_paths(root, documents, report)
        check_tables(root, documents, report)
    elif what == "code":
        check_code(root, pathlib.Path(arguments[2]).resolve(), documents, report)
    else:
        check_commands(root, pathlib.Path(arguments[2]).resolve(), pathlib.Path(arguments[3]).resolve(), documents, report)
    for error in report.errors:
        print(error, file=sys.stderr)
    print(f"{what} of {len(documents)} documents: {len(report.errors)} errors")
    sys.exit(1 if report.errors else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
