"""Compiles the C++ and the C of documents and configures their CMake."""

import json
import os
import pathlib
import re
import shlex
import subprocess
import tempfile

OPTIONS_WITH_VALUE = {"-o", "-MF", "-MT", "-MQ"}


def compile_command(build):
    """How a demo is compiled, to look at the syntax alone; without the source."""
    for entry in json.loads((build / "compile_commands.json").read_text()):
        if entry["file"].endswith("demos/smallest_checker.cpp"):
            break
    else:
        raise SystemExit(f"{build}/compile_commands.json has no demos/smallest_checker.cpp, expected a build with demos")
    words = iter(shlex.split(entry["command"]))
    command = []
    for word in words:
        if word in OPTIONS_WITH_VALUE:
            next(words)
        elif not word.startswith(("-O", "-g", "-M", "-fsanitize")) and word not in ("-c", entry["file"]):
            command.append(word)
    return command + ["-fsyntax-only", "-Werror"], entry["directory"]


def before(block):
    """The code that comments put before the block's, with its line."""
    return [(line, text[len("before") :].strip("\n")) for line, text in block.directives if text.startswith("before")]


def place(document, line):
    return f'#line {line} "{document.name}"\n'


def program_of_pieces(document, blocks):
    """One function, in C++ and in C, of all pieces, in order; what they include comes first."""
    includes, body = [], []
    for block in blocks:
        for line, text in before(block) + [(block.line, block.text)]:
            for number, row in enumerate(text.split("\n")):
                if row.startswith("#include"):
                    includes.append(place(document, line + number) + row + "\n")
            body.append(place(document, line) + re.sub(r"^#include.*$", "", text, flags=re.M) + "\n")
    return "".join(includes) + "void pieces(void) {\n" + "".join(body) + "}\n"


def programs_of(root, document):
    """The sources to compile, each with the line it begins at. A demo is compiled as what it is."""
    demos = {path.read_text() for path in (root / "demos").glob("*.cpp")}
    pieces = []
    for block in document.blocks:
        if block.language != "cpp":
            continue
        if re.search(r"\bint main\(", block.text):
            if block.text not in demos:
                yield block.line, place(document, block.line) + block.text
        else:
            pieces.append(block)
    if pieces:
        yield pieces[0].line, program_of_pieces(document, pieces)


def compile_c(root, build, documents, report):
    """Whole programs and pieces in C, as C99."""
    command = ["cc", "-std=c99", "-pedantic", "-Werror", "-fsyntax-only", "-x", "c"]
    command += ["-I", str(root / "include"), "-I", str(build / "generated/include"), "-"]
    for document in documents:
        blocks = [block for block in document.blocks if block.language == "c"]
        pieces = [block for block in blocks if not re.search(r"\bint main\(", block.text)]
        sources = [(block.line, place(document, block.line) + block.text) for block in blocks if block not in pieces]
        if pieces:
            sources.append((pieces[0].line, program_of_pieces(document, pieces)))
        for line, source in sources:
            done = subprocess.run(command, input=source, capture_output=True, text=True)
            if done.returncode != 0:
                report.refuse(document, line, "the C does not compile:\n" + done.stderr)


def compile_documents(root, build, documents, report):
    programs = [(document, line, source) for document in documents for line, source in programs_of(root, document)]
    if not programs:
        return
    command, folder = compile_command(build)
    for document, line, source in programs:
        done = subprocess.run(command + ["-x", "c++", "-"], cwd=folder, input=source, capture_output=True, text=True)
        if done.returncode != 0:
            report.refuse(document, line, "the C++ does not compile:\n" + done.stderr)


def configure(root, build, block):
    """Configures a project that has the repository as its folder clearway, as the document's reader would, and finds an
    installation of the build."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        (folder / "clearway").symlink_to(root)
        (folder / "main.cpp").write_text("int main() {}\n")
        lines = ["cmake_minimum_required(VERSION 3.25)", "project(reader LANGUAGES CXX)"]
        lines += [text for _, text in before(block)]
        (folder / "CMakeLists.txt").write_text("\n".join(lines) + "\n" + block.text)
        prefix = scratch + "/prefix"
        if "find_package(clearway" in block.text:
            subprocess.run(["cmake", "--install", build, "--prefix", prefix], check=True, capture_output=True)
        environment = {name: value for name, value in os.environ.items() if name != "CXXFLAGS"}
        return subprocess.run(
            ["cmake", "-Wno-dev", "-S", scratch, "-B", scratch + "/build", "-DCMAKE_PREFIX_PATH=" + prefix],
            capture_output=True, text=True, env=environment,
        )


def check_code(root, build, documents, report):
    compile_documents(root, build, documents, report)
    compile_c(root, build, documents, report)
    for document in documents:
        for block in document.blocks:
            if block.language != "cmake":
                continue
            done = configure(root, build, block)
            if done.returncode != 0:
                report.refuse(document, block.line, "CMake refuses the block:\n" + done.stderr)
