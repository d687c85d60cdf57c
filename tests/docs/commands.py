"""Runs the commands of documents, or checks the names and options in them."""

import functools
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import tempfile

SECONDS = 3600  # for one command
TOOLS = ("clearway-scene", "clearway-study")  # programs without subcommands
KNOWN = "clearway, clearway-cad, clearway-scene, clearway-study, ./demos/run, ./tests/run, cmake, ctest, export, sed, programs below build/dev and scripts below tests, and mpirun -n N before any of them"


class Refused(Exception):
    pass


def is_full():
    return os.environ.get("CLEARWAY_FULL", "") not in ("", "0")


def commands_in(text):
    """The commands of a block, one a line: comments left out, lines that end with a backslash joined, && taken apart.
    `demos/run scene` and `study` are the programs that they build and run, which the build folder has."""
    text = re.sub(r"\./demos/run (scene|study)\b", r"clearway-\1", text)
    for line in re.sub(r"\\\n\s*", " ", text).split("\n"):
        for part in line.split("&&"):
            words = shlex.split(part, comments=True)
            if words:
                yield part.strip(), words


def options_in(words):
    return [word.split("=")[0] for word in words if word.startswith("--") and len(word) > 2]


def help_options(command):
    """The options that `COMMAND --help` lists."""
    done = subprocess.run(command + ["--help"], capture_output=True, text=True, timeout=SECONDS)
    if done.returncode != 0:
        raise Refused(f"'{' '.join(command)} --help' ends with {done.returncode}")
    return set(re.findall(r"(?<![\w-])--[a-z][\w-]*", done.stdout + done.stderr)) | {"--help"}


class Checker:
    """Knows the names and options that commands may have."""

    def __init__(self, root, build, program):
        self.root, self.build, self.program = root, build, program
        self.help_options = functools.lru_cache(None)(lambda *command: help_options(list(command)))

    @functools.cached_property
    def subcommands(self):
        done = subprocess.run([self.program, "--help"], capture_output=True, text=True, check=True)
        return re.findall(r"^  ([a-z]+) {2,}", done.stdout, re.M)

    @functools.cached_property
    def targets(self):
        done = subprocess.run(["cmake", "--build", self.build, "--target", "help"], capture_output=True, text=True, check=True)
        return set(re.findall(r"^(?:\.\.\. )?([\w.-]+)(?::|$| )", done.stdout, re.M))

    @functools.cached_property
    def cmake_text(self):
        files = [self.root / "CMakeLists.txt", *(self.root / "cmake").glob("*.cmake"), *(self.root / "tests").rglob("CMakeLists.txt")]
        return "\n".join(path.read_text() for path in files if path.exists())

    def require_options(self, words, known, of):
        for option in options_in(words):
            if option not in known:
                raise Refused(f"{of} has no option '{option}'")

    def clearway(self, words):
        if not words or words[0].startswith("-"):
            return self.require_options(words, {"--help", "--version"}, "clearway")
        if words[0] not in self.subcommands:
            raise Refused(f"clearway has no subcommand '{words[0]}', expected one of {', '.join(self.subcommands)}")
        self.require_options(words[1:], self.help_options(str(self.program), words[0]), f"clearway {words[0]}")

    def tool_options(self, name):
        return self.help_options(str(self.program.with_name(name)))

    def demos_run(self, words):
        usage = subprocess.run([self.root / "demos/run", "--help"], capture_output=True, text=True, check=True).stdout
        names = re.findall(r"^    (\w+)", usage, re.M)
        takes_arguments = words[:1] == ["disassemble"]
        if (len(words) > 1 and not takes_arguments) or any(word not in names + ["NAME", "--help"] for word in words[:1]):
            raise Refused(f"demos/run has no demo '{' '.join(words)}', expected one of {', '.join(names)}")

    def require_test(self, pattern):
        tests = subprocess.run(["ctest", "--test-dir", self.build, "-N", "-R", pattern], capture_output=True, text=True)
        if not re.search(r"Total Tests: [1-9]", tests.stdout):
            raise Refused(f"no test's name matches '{pattern}'")

    def tests_run(self, words):
        self.require_options(words, {"--full", "--stage"}, "tests/run")
        stages = re.search(r"^stages=\((.*)\)$", (self.root / "tests/run").read_text(), re.M).group(1).split()
        for word in words:
            if word.startswith("--"):
                continue
            if "--stage" not in words:
                self.require_test(word)
            elif word not in stages:
                raise Refused(f"tests/run has no stage '{word}', expected one of {', '.join(stages)}")

    def require_preset(self, kind, name):
        presets = json.loads((self.root / "CMakePresets.json").read_text())[kind]
        if name not in [preset["name"] for preset in presets]:
            raise Refused(f"CMakePresets.json has no preset '{name}' in {kind}")

    def cmake(self, words):
        words = list(words)
        kind = "buildPresets" if "--build" in words else "configurePresets"
        while words:
            word = words.pop(0)
            if word == "--preset":
                self.require_preset(kind, words.pop(0))
            elif word == "--target":
                if words[0] not in self.targets:
                    raise Refused(f"the build has no target '{words[0]}'")
                words.pop(0)
            elif word.startswith("-D"):
                if not re.search(r"\b" + re.escape(word[2:].split("=")[0]) + r"\b", self.cmake_text):
                    raise Refused(f"no CMake file knows the variable of '{word}'")
            elif word != "--build":
                raise Refused(f"'{word}' of cmake is not known here, expected --preset, --build, --target or -DNAME=VALUE")

    def ctest(self, words):
        words = list(words)
        while words:
            word = words.pop(0)
            if word == "--preset":
                self.require_preset("testPresets", words.pop(0))
            elif word in ("-R", "-L"):
                pattern = words.pop(0)
                if word == "-R":
                    self.require_test(pattern)
            else:
                raise Refused(f"'{word}' of ctest is not known here, expected --preset, -R or -L")

    def test_program(self, name, words):
        program = self.build / "tests" / name
        if not program.exists():
            raise Refused(f"there is no program {program}")
        command = [str(program)]
        if name == "benchmarks":
            command += [word for word in words[:1] if not word.startswith("-")]
            known = re.findall(r"^  (\w+)$", subprocess.run([program, "--help"], capture_output=True, text=True).stdout, re.M)
            if not words or words[0] not in known + ["--help"]:
                raise Refused(f"there is no benchmark '{' '.join(words[:1])}', expected one of {', '.join(known)}")
        if options_in(words):
            self.require_options(words, self.help_options(*command), " ".join([name] + command[1:]))

    def script(self, name, words):
        if not (self.root / name).exists():
            raise Refused(f"there is no script {name}")
        text = (self.root / name).read_text()
        self.require_options(words, set(re.findall(r"--[a-z][\w-]*", text)), name)

    def check(self, words):
        """Throws Refused when a command's name, or an option of it, is unknown."""
        if ">" in words:
            words = words[: words.index(">")]
        name, rest = words[0], words[1:]
        if name in ("clearway", "build/release/bin/clearway"):
            self.clearway(rest)
        elif name in TOOLS:
            self.require_options(rest, self.tool_options(name) | {"--version"}, name)
        elif name == "clearway-cad":  # built where OpenCASCADE is found
            if self.program.with_name(name).exists():
                self.require_options(rest, self.tool_options(name) | {"--version"}, name)
        elif name in ("./demos/run", "demos/run"):
            self.demos_run(rest)
        elif name in ("./tests/run", "tests/run"):
            self.tests_run(rest)
        elif name == "cmake":
            self.cmake(rest)
        elif name == "ctest":
            self.ctest(rest)
        elif re.fullmatch(r"build/\w+/tests/\w+|benchmarks|torture|test_\w+", name):
            self.test_program(name.split("/")[-1], rest)
        elif re.fullmatch(r"tests/[\w/.]+", name):
            self.script(name, rest)
        elif name == "mpirun" and len(rest) > 2 and rest[0] == "-n" and rest[1].isdigit():
            self.check(rest[2:])
        elif name not in ("export", "sed"):
            raise Refused(f"unknown command '{name}', expected one of {KNOWN}")


class Runner:
    """Takes the blocks of one document, in order, in a scratch folder."""

    def __init__(self, checker, document, report, scratch):
        self.checker, self.document, self.report = checker, document, report
        self.folder = pathlib.Path(scratch)
        if (checker.root / "data").exists():
            shutil.copytree(checker.root / "data", self.folder / "data")
        bin_folder = self.folder / "build/release/bin"
        bin_folder.mkdir(parents=True)
        for name in ("clearway", *TOOLS):
            (bin_folder / name).symlink_to(checker.program.with_name(name))
        self.environment = dict(os.environ, PATH=f"{bin_folder}:{os.environ['PATH']}")

    def take(self, block):
        directives = [text for _, text in block.directives]
        text = self.adjusted(block, directives)
        file = next((directive for directive in directives if directive.startswith("file ")), None)
        if file:
            self.write(file, text, block.line)
        elif block.language == "ini":
            raise Refused("an ini block needs a directive `file NAME`")
        elif block.language == "sh":
            is_left_out = "options only" in directives or ("full" in directives and not is_full())
            expected = next((int(text.split()[-1]) for text in directives if text.startswith("exits with")), 0)
            commands = list(commands_in(text))
            for i, (line, words) in enumerate(commands):
                self.checker.check(words)
                if not is_left_out:
                    self.run(line, words, expected if i + 1 == len(commands) else 0)

    def adjusted(self, block, directives):
        text = block.text
        for directive in directives:
            change = re.fullmatch(r'"(.+?)" becomes "(.*)"', directive)
            if change and change.group(1) not in text:
                raise Refused(f"the block does not hold '{change.group(1)}'")
            if change and not is_full():
                text = text.replace(*change.groups())
        return text

    def require_named(self, name, line):
        """A reader sees no directive: the text above the block must say which file it is."""
        if not any(text == name and at < line for at, text in self.document.spans):
            raise Refused(f"the text before the block does not name `{name}`")

    def write(self, directive, text, line):
        name, _, base = directive[len("file ") :].partition(" begins as ")
        self.require_named(name, line)
        if base:
            base, _, end = base.partition(" up to ")
            self.require_named(base, line)
            start = (self.folder / base).read_text()
            if end not in start:
                raise Refused(f"{base} does not hold '{end}'")
            text = (start[: start.index(end)] if end else start) + "\n" + text
        (self.folder / name).write_text(text)
        if name.endswith(".cfg"):
            line = f"clearway info {shlex.quote(name)}"
            self.run(line, shlex.split(line), 0)

    def run(self, line, words, expected):
        folder = self.folder
        if words[0].endswith("demos/run") and "--help" not in words:
            if not is_full():
                return
            folder = self.checker.root
        elif words[0] not in ("clearway", "build/release/bin/clearway", *TOOLS, "sed"):
            return
        done = subprocess.run(
            ["bash", "-c", line], cwd=folder, env=self.environment, capture_output=True, text=True, timeout=SECONDS
        )
        if done.returncode != expected:
            raise Refused(f"'{line}' ends with {done.returncode}, expected {expected}:\n{done.stdout[-2000:]}{done.stderr}")
        warnings = re.findall(r"^(?:clearway: )?warning:.*", done.stdout + done.stderr, re.M)
        if warnings:
            raise Refused(f"'{line}' warns: {warnings[0]}")


def is_run(document):
    return document.name in ("README.md", "CONTRIBUTING.md") or document.name.startswith("docs/")


def check_spans(checker, document, report):
    """Options that the text names: of a subcommand when it names one, else of any."""
    known = {"--help", "--version", "--full", "--deflection"}  # the last one is clearway-cad's, which is not built everywhere
    for subcommand in checker.subcommands:
        known |= checker.help_options(str(checker.program), subcommand)
    for tool in TOOLS:
        known |= checker.tool_options(tool)
    for line, text in document.spans:
        words = text.split()
        named = words[1:] if words[:1] == ["clearway"] else words
        try:
            if named and named[0] in checker.subcommands:
                checker.clearway(named)
            elif words and words[0] in TOOLS:
                checker.check(words)
            elif text.startswith("--"):
                checker.require_options(words, known, "clearway")
        except Refused as refusal:
            report.refuse(document, line, str(refusal))


def check_commands(root, build, program, documents, report):
    checker = Checker(root, build, program)
    for document in documents:
        if is_run(document):
            check_spans(checker, document, report)
        with tempfile.TemporaryDirectory() as scratch:
            runner = Runner(checker, document, report, scratch)
            for block in document.blocks:
                try:
                    if block.language in ("sh", "ini") and is_run(document):
                        runner.take(block)
                    elif block.language in ("sh", "indented"):
                        for _, words in commands_in(block.text) if looks_like_commands(block) else ():
                            checker.check(words)
                except Refused as refusal:
                    report.refuse(document, block.line, str(refusal))


def looks_like_commands(block):
    return block.language == "sh" or re.match(r"(cmake|clearway|build/|tests/|benchmarks )", block.text) is not None
