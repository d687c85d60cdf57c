#!/usr/bin/env python3
"""reference.py DOXYGEN DOXYFILE ROOT: makes the reference, and refuses public symbols without a description and dead links.

A small tree full of faults shows that each of them is told, a good one that nothing else is. Enumerators without a description are
looked for in Doxygen's XML, because Doxygen 1.9.4 does not warn of them.
"""

import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

TYPES = """// The values of a small library.
#pragma once

/// @namespace clearway
/// A small library.

#pragma GCC visibility push(default)

namespace clearway {

/// A box of a square base.
struct Crate {
    double height = 1;  ///< mesh units
};

/// The ways to look.
enum class View {
    kTop,  ///< from above
    kSide  ///< from the right
};

/// The volume of a crate. Throws std::invalid_argument as checked() does.
double volume(const Crate& crate);

}  // namespace clearway

#pragma GCC visibility pop
"""

C_HEADER = """// The library for C.
#ifndef CLEARWAY_H
#define CLEARWAY_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// A part, by its number.
typedef uint64_t clearway_part;

/// Frees a part.
void clearway_free(clearway_part part);

#ifdef __cplusplus
}
#endif

#endif
"""

PLAIN = "// A header of no use.\n#pragma once\n"
LANDING = """# Reference

[The guide](guide.md), [types.h](../include/clearway/types.h)
"""
GUIDE = "# A guide\n\n## What it is `for`\n\nSee [what](#what-it-is-for) and [the reference](reference.md). `clearway::volume` is one.\n"

# Faults of one tree: the file, what is replaced in it by what, and words of the refusal.
FAULTS = [
    ("types.h", "/// A box of a square base.\n", "\n", "types.h:12: error: Compound clearway::Crate is not documented"),
    ("types.h", "  ///< mesh units", "", "types.h:13: error: Member height"),
    ("types.h", "  ///< from above", "", "types.h: View::kTop is not documented"),
    ("types.h", "/// The ways to look.\n", "", "Member View (enumeration)"),
    ("types.h", "}  // namespace", "double weight(const Crate& crate);\n\n}  // namespace", "Member weight(const Crate &crate) (function)"),
    ("types.h", "}  // namespace", "using Height = double;\n\n}  // namespace", "Member Height (typedef)"),
    ("types.h", "}  // namespace", "constexpr int kTwo = 2;\n\n}  // namespace", "Member kTwo (variable)"),
    ("types.h", "}  // namespace", "#define CLEARWAY_SMALL 1\n\n}  // namespace", "Member CLEARWAY_SMALL (macro definition)"),
    ("types.h", "as checked() does", "as @ref checked does", "unable to resolve reference to 'checked'"),
    ("types.h", "of a crate.", "of a <b>crate.", "end of comment block while expecting command </b>"),
    ("plain.h", "// A header of no use.\n", "\n", "plain.h: begins without a comment about the file"),
    ("small.h", "/// Frees a part.\n", "", "Member clearway_free(clearway_part part) (function)"),
    ("small.h", "/// A part, by its number.\n", "", "Member clearway_part (typedef)"),
    ("guide.md", "[the reference](reference.md)", "[the reference](gone.md)", "unable to resolve reference to 'gone'"),
    ("guide.md", "#what-it-is-for", "#what-it-was", "unable to resolve reference to 'guide_what-it-was'"),
    ("reference.md", "[The guide](guide.md), ", "", "reference.md: does not lead to docs/guide.md"),
]


def is_empty(element):
    return not any("".join(element.find(kind).itertext()).strip() for kind in ("briefdescription", "detaileddescription"))


def undocumented(folder, root):
    """Public symbols without a description that Doxygen itself passes over."""
    described = set()
    for path in sorted(folder.glob("*.xml")):
        for compound in xml.etree.ElementTree.parse(path).iter("compounddef"):
            name = compound.findtext("compoundname")
            if compound.get("kind") == "file" and name.endswith(".h"):
                described.add(name)
                if is_empty(compound):
                    yield f"{name}: begins without a comment about the file"
            for member in compound.iter("memberdef"):
                for value in member.findall("enumvalue"):
                    if is_empty(value) and member.get("prot") != "private":
                        file = pathlib.Path(member.find("location").get("file")).name
                        yield f"{file}: {member.findtext('name')}::{value.findtext('name')} is not documented"
    for header in sorted(root.glob("include/**/*.h")):
        if header.name not in described:
            yield f"{header.name}: is not in the reference"
    landing = (root / "docs/reference.md").read_text()
    for path in sorted((root / "docs").glob("*.md")):
        if f"]({path.name})" not in landing and path.name != "reference.md":
            yield f"reference.md: does not lead to docs/{path.name}"


def faults(doxygen, doxyfile, root, more=""):
    """The reference of ROOT's docs and include, made in a scratch folder: a list of lines about what is wrong with it."""
    with tempfile.TemporaryDirectory() as scratch:
        settings = doxyfile.read_text() + f'OUTPUT_DIRECTORY = "{scratch}"\nGENERATE_XML = YES\n{more}'
        done = subprocess.run([doxygen, "-"], input=settings, capture_output=True, text=True)
        lines = (done.stdout + done.stderr).splitlines()
        if done.returncode != 0 and not lines:
            lines.append(f"doxygen ends with {done.returncode}")
        return lines + sorted(set(undocumented(pathlib.Path(scratch) / "xml", root)))


def faults_of_small_tree(doxygen, doxyfile, edits):
    texts = {"types.h": TYPES, "small.h": C_HEADER, "plain.h": PLAIN, "reference.md": LANDING, "guide.md": GUIDE}
    for file, old, new, _ in edits:
        if old not in texts[file]:
            sys.exit(f"{file} does not hold '{old}'")
        texts[file] = texts[file].replace(old, new, 1)
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        for name, text in texts.items():
            path = folder / ("docs" if name.endswith(".md") else "include/clearway") / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        more = f'INPUT = "{folder}/docs" "{folder}/include"\nUSE_MDFILE_AS_MAINPAGE = "{folder}/docs/reference.md"\nSTRIP_FROM_PATH = "{folder}/include"\nIMAGE_PATH =\nGENERATE_HTML = NO\n'
        return faults(doxygen, doxyfile, folder, more)


def main(doxygen, doxyfile, root):
    wrong = faults(doxygen, doxyfile, root)
    print("\n".join(wrong + [f"the reference: {len(wrong)} faults"]))
    refused = faults_of_small_tree(doxygen, doxyfile, [])
    if refused:
        print("\n".join(["a good tree is refused:"] + refused))
    found = "\n".join(faults_of_small_tree(doxygen, doxyfile, FAULTS))
    missed = [words for _, _, _, words in FAULTS if words not in found]
    if missed:
        print("\n".join(["not told:"] + missed + ["but:", found]))
    print(f"{len(FAULTS)} faults of a small tree, {len(missed)} not told")
    return 1 if wrong or refused or missed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], *(pathlib.Path(argument).resolve() for argument in sys.argv[2:4])))
