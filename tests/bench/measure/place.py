"""Where a row is measured: the programs, the scratch folder, and the problems, which are made once."""

import functools
import os
import pathlib
import shutil
import subprocess

# Scenes as problems: the scene's name and the options it is made with.
GENERATED = {
    "tunnel-console-3": ("tunnel-console-3", []),
    "tunnel-console-3-2mm": ("tunnel-console-3", ["--clearance", "2"]),
    "cembox-2": ("cembox-2", []),
    "large-environment-2": ("large-environment-2", []),
}


class Refused(Exception):
    """The caller's mistake, or something that is missing: one line says what, and what was expected."""


class Place:
    def __init__(self, form, root, build, scratch, checkouts=None, cpu=None, make=lambda target: None):
        """make: builds a target; it is asked once for each program, when that is first named."""
        self.form, self.root, self.build, self.scratch = form, root, build, scratch
        self.checkouts = checkouts
        # The last processor: the first one serves most interrupts.
        self.cpu = max(os.sched_getaffinity(0)) if cpu is None else cpu
        self.make = functools.lru_cache(None)(make)

    def test_program(self, name):
        self.make(name)
        return self.build / "tests" / name

    def benchmark(self, name):
        """The first words of a command that runs a benchmark."""
        return self.test_program("benchmarks"), name

    def program(self, name="clearway"):
        self.make(name if name.startswith("demo_") else name.replace("-", "_") + "_program")
        return self.build / "bin" / name

    def pinned(self, *command):
        """For programs that do not pin themselves."""
        return ["taskset", "-c", str(self.cpu), *command]

    def scene(self, name):
        """The folder of a scene, made when it is first asked for and kept beside the build."""
        scene, options = GENERATED[name]
        folder = self.build / "bench-scenes" / name
        if not folder.exists():
            temporary = pathlib.Path(f"{folder}.part")
            shutil.rmtree(temporary, ignore_errors=True)
            temporary.parent.mkdir(parents=True, exist_ok=True)
            self.run([self.program("clearway-scene"), scene, *options, "--no-preview", "--out", temporary])
            temporary.rename(folder)
        return folder

    def problem(self, name):
        """A problem's .cfg: one of data, a scene, or one of a checkout."""
        if name in GENERATED:
            return next(self.scene(name).glob("*.cfg"))
        here = sorted((self.root / "data" / name).glob("*.cfg"))
        if here:
            return here[0]
        if self.checkouts:
            for file in (f"omplapp/resources/3D/{name}.cfg", f"{name}/{name}.cfg"):
                if (self.checkouts / file).exists():
                    return self.checkouts / file
        raise Refused(f"the problem '{name}' is neither in data nor in the folder of --checkouts ({self.checkouts or 'not given'})")

    def path(self, name):
        return next(self.scene(name).glob("*.path"))

    @staticmethod
    def run(command):
        """Returns what the command prints; throws Refused if it fails."""
        words = [str(word) for word in command]
        done = subprocess.run(words, capture_output=True, text=True)
        if done.returncode != 0:
            raise Refused(f"'{' '.join(words)}' ends with {done.returncode}:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
        return done.stdout
