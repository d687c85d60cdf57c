#!/usr/bin/env python3
"""catches.py ROOT BUILD PROGRAM: shows that check.py refuses what is wrong with a document, each fault by itself.

Every case writes one document into a small repository of its own and names the words that check.py must answer with.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

FENCE = "```"
CHECK = pathlib.Path(__file__).with_name("check.py")

PROBLEM = """[problem]
robot = cart.obj
world = wall.obj
start.x = -80
start.y = -40
start.theta = 0
goal.x = 80
goal.y = -40
goal.theta = 0
"""

SOUND = f"""# A sound document

[Here](#a-sound-document), [there](README.md#a-sound-document), [outside](https://ompl.kavrakilab.org) and `docs/page.md`.
`plan --floor D` and `--margin M` are options.

{FENCE}cpp
#include <clearway/mesh.h>
clearway::Mesh mesh;
{FENCE}

<!-- test: before #include <clearway/clearway.h> -->
{FENCE}c
clearway_handle model = 0;
clearway_free(model);
{FENCE}

<!-- test: before const clearway::Box box; -->
{FENCE}cpp
mesh = clearway::boxMesh(box);
{FENCE}

In `data/gates/new.cfg`, a copy of `data/gates/gates.cfg` with a line more:

<!-- test: file data/gates/new.cfg begins as data/gates/gates.cfg -->
{FENCE}ini
margin = 0.5
{FENCE}

<!-- test: "--poses nothing" becomes "--part-triangles 1e3" -->
<!-- test: exits with 2 -->
{FENCE}sh
export PATH=$PWD/build/release/bin:$PATH   # a comment
clearway info data/gates/new.cfg && clearway info \\
    data/gates/cart.obj
clearway-scene boxes --out S --poses nothing
{FENCE}

    clearway-scene boxes --out S
"""


def fenced(language, text):
    return f"{FENCE}{language}\n{text}\n{FENCE}\n"


# Each case: the check, the document, and words of the refusal; no words: the document is good.
CASES = [
    ("links", SOUND, ""),
    ("code", SOUND, ""),
    ("commands", SOUND, ""),
    ("links", "[there](gone.md)", "'gone.md' leads to no file"),
    ("links", "text [over two\nlines](gone.md)", "docs/page.md:1: the link 'gone.md' leads to no file"),
    ("links", "| cell |\n|---|\n| [there](gone.md) |", "docs/page.md:3: the link 'gone.md'"),
    ("links", "![a picture](gone.png)", "'gone.png' leads to no file"),
    ("links", "# One\n[here](#two)", "'#two' leads to no heading"),
    ("links", "[there](../README.md#nowhere)", "'../README.md#nowhere' leads to no heading"),
    ("links", "[there](../../etc)", "leads"),
    ("links", "[there](http:/ompl)", "is no address"),
    ("links", "see `src/gone/file.cpp`", "`src/gone/file.cpp` is not there"),
    ("links", "<!-- test: layering -->\n| room | may |\n|---|---|\n| `core` | `mesh` |\n", "core may include no other"),
    ("links", "<!-- test: layering -->\n| room | may |\n|---|---|\n| `core` | |\n", "mesh may include core"),
    ("links", "<!-- test: headers of include/clearway -->\n| task | header |\n|---|---|\n| | [a](../include/clearway/mesh.h) |\n", "clearway/model.h is there 1 times, in the table 0"),
    ("links", "<!-- test: headers of include/clearway -->\n| task | header |\n|---|---|\n| | [a](../include/clearway/planning/plan.h) |\n", "clearway/plan.h is there 0 times"),
    ("links", "<!-- test: headers of include/none -->\n| task | header |\n|---|---|\n", "include/none has no headers"),
    ("links", fenced("yaml", "a: b"), "the block's language is 'yaml'"),
    ("links", "<!-- test: ful -->\n" + fenced("sh", "clearway --help"), "unknown directive 'ful'"),
    ("links", "<!-- test: full -->\ntext", "stands before no block"),
    ("code", fenced("cpp", "#include <clearway/mesh.h>\nclearway::Mash mesh;"), "docs/page.md:3"),
    ("code", fenced("cpp", "int a = 1;") + "\n" + fenced("cpp", "int b = c;"), "docs/page.md:6"),
    ("code", fenced("cpp", '#include "clearway/gone.h"'), "clearway/gone.h"),
    ("code", fenced("cpp", "int main() { return gone; }"), "docs/page.md:2"),
    ("code", fenced("c", "int a = 1;") + "\n" + fenced("c", "int b = c;"), "docs/page.md:6"),
    ("code", fenced("c", "int main(void) { return gone; }"), "docs/page.md:2"),
    ("code", fenced("c", "for (int i = 0; i < 2; ++i) auto j = i;"), "the C does not compile"),
    ("code", fenced("cmake", "target_link_libraries(reader PRIVATE clearway::planning)"), "CMake refuses"),
    ("commands", fenced("sh", "clearway plan data/gates/gates.cfg --paths a.path"), "has no option '--paths'"),
    ("commands", "<!-- test: options only -->\n" + fenced("sh", "clearway plan --paths=a"), "has no option '--paths'"),
    ("commands", "<!-- test: full -->\n" + fenced("sh", "clearway plan --paths a"), "has no option '--paths'"),
    ("commands", fenced("sh", "clearway-study --runs 2"), "has no option '--runs'"),
    ("commands", fenced("sh", "clearway plane"), "has no subcommand 'plane'"),
    ("commands", fenced("sh", "rm everything"), "unknown command 'rm'"),
    ("commands", fenced("sh", "clearway info data/gates/gone.cfg"), "ends with 2, expected 0"),
    ("commands", "<!-- test: exits with 1 -->\n" + fenced("sh", "clearway info data/gates/gates.cfg"), "expected 1"),
    ("commands", '<!-- test: "b1" becomes "b2" -->\n' + fenced("sh", "clearway --help"), "does not hold 'b1'"),
    ("commands", "`plan --stop S`", "has no option '--stop'"),
    ("commands", "`--stop`", "has no option '--stop'"),
    ("commands", fenced("sh", "./demos/run gone"), "has no demo 'gone'"),
    ("commands", fenced("sh", "./tests/run --fool"), "has no option '--fool'"),
    ("commands", fenced("sh", "./tests/run no_such_test"), "no test's name matches"),
    ("commands", fenced("sh", "./tests/run --stage gone"), "has no stage 'gone'"),
    ("commands", fenced("sh", "cmake --preset gone"), "no preset 'gone'"),
    ("commands", fenced("sh", "cmake --preset dev -DCLEARWAY_GONE=1"), "no CMake file knows"),
    ("commands", fenced("sh", "cmake --build --preset dev --target gone"), "no target 'gone'"),
    ("commands", fenced("sh", "build/dev/tests/gone"), "there is no program"),
    ("commands", fenced("sh", "benchmarks gone"), "there is no benchmark 'gone'"),
    ("commands", fenced("sh", "build/dev/tests/benchmarks queries --gone"), "benchmarks queries has no option '--gone'"),
    ("commands", fenced("sh", "tests/bench/gone.py"), "there is no script"),
    ("commands", "text\n\n    clearway query --gone\n", "has no option '--gone'"),
    ("commands", fenced("ini", "[clearway]"), "needs a directive"),
    ("commands", "<!-- test: file data/gates/a.cfg -->\n" + fenced("ini", PROBLEM), "does not name `data/gates/a.cfg`"),
    ("commands", "`data/gates/a.cfg`\n\n<!-- test: file data/gates/a.cfg -->\n" + fenced("ini", PROBLEM + "[clearway]\nmarign = 1"), "unknown key"),
    ("commands", "`data/gates/a.cfg`\n\n<!-- test: file data/gates/a.cfg -->\n" + fenced("ini", PROBLEM + "colour = red"), "warns"),
]


def small_repository(folder, root, document):
    (folder / "docs").mkdir()
    (folder / "docs/page.md").write_text(document)
    (folder / "docs/README.md").write_text("# A sound document\n")
    (folder / "README.md").write_text("# A small repository\n")
    for name in ("demos", "cmake", "tests", "CMakePresets.json", "CMakeLists.txt", "src", "include"):
        (folder / name).symlink_to(root / name)
    (folder / "data").mkdir()
    (folder / "data/gates").symlink_to(root / "data/gates")


def answer(arguments):
    environment = {name: value for name, value in os.environ.items() if name != "CLEARWAY_FULL"}
    done = subprocess.run([sys.executable, CHECK, *arguments], capture_output=True, text=True, env=environment)
    return done.returncode, done.stdout + done.stderr


def main(root, build, program):
    failures = 0
    for what, document, words in CASES:
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            small_repository(folder, root, document)
            more = {"links": [], "code": [build], "commands": [build, program]}[what]
            code, text = answer([what, folder, *more])
        if code != (1 if words else 0) or words not in text:
            failures += 1
            print(f"check.py {what} ends with {code}, expected '{words or 'no error'}'; the document:\n{document}\nit said:\n{text}")
    print(f"{len(CASES)} documents, {failures} not judged as expected")
    return 1 if failures or not CASES else 0


if __name__ == "__main__":
    sys.exit(main(*(pathlib.Path(argument).resolve() for argument in sys.argv[1:4])))
