"""Describes the machine and the build that a row is measured with, and notices other work on the machine."""

import datetime
import os
import pathlib
import platform
import re
import resource
import subprocess
import time

# Two machines differ if one of these does: rows of different machines are not compared.
IDENTITY = ("cpu", "cores", "memory_gb", "instruction_set")


def said_by(*command, folder=None):
    """The first line that a command prints; empty if it cannot be run."""
    try:
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    except OSError:
        return ""
    return done.stdout.strip().split("\n")[0] if done.returncode == 0 else ""


def commit_of(folder):
    """The commit of a checkout, with '+' if files other than results differ from it; empty if it is no checkout of its own."""
    top = said_by("git", "rev-parse", "--show-toplevel", folder=folder)
    if not top or pathlib.Path(top).resolve() != pathlib.Path(folder).resolve():
        return ""
    changed = said_by("git", "status", "--porcelain", "--untracked-files=no", "--", ".", ":!tests/bench/results", folder=folder)
    return said_by("git", "rev-parse", "--short=12", "HEAD", folder=folder) + ("+" if changed else "")


def cache_of(build):
    """The variables of a build's CMakeCache.txt."""
    text = (build / "CMakeCache.txt").read_text()
    return dict(re.findall(r"^([^#/\n:]+):\w+=(.*)$", text, re.M))


def pqp_of(cache):
    folder = cache.get("CLEARWAY_BENCH_PQP", "")
    if not folder:
        return "not measured"
    return f"{commit_of(folder) or 'no commit known'}, {cache.get('CLEARWAY_BENCH_PQP_FLAGS', '')}"


def installed_version(prefix, config):
    """The version that a CMake package states in its files below the prefix."""
    if not prefix:
        return "not measured"
    for file in pathlib.Path(prefix).rglob(config):
        version = re.search(r'PACKAGE_VERSION "([^"]+)"', file.read_text())
        if version:
            return version.group(1)
    return "no version known"


def bullet_of(cache):
    is_found = not cache.get("Bullet_DIR", "NOTFOUND").endswith("NOTFOUND")
    return f"{package_version('libbullet-dev')}, double" if is_found else "not measured"


def package_version(name):
    return said_by("dpkg-query", "-W", "-f=${Version}", name) or said_by("pkg-config", "--modversion", name) or "no version known"


def build_record(root, build):
    """What the programs were made of."""
    cache = cache_of(build)
    kind = cache.get("CMAKE_BUILD_TYPE", "")
    flags = f"{cache.get('CMAKE_CXX_FLAGS', '')} {cache.get('CMAKE_CXX_FLAGS_' + kind.upper(), '').replace('-DNDEBUG', '').strip()}"
    versions = subprocess.run([build / "bin/clearway", "--version"], capture_output=True, text=True).stdout
    target = re.search(r"instruction set:?\s+(\S+)", versions)
    return {
        "clearway": commit_of(root) or "no commit known",
        "pqp": pqp_of(cache),
        "coal": installed_version(cache.get("CLEARWAY_BENCH_COAL"), "coalConfigVersion.cmake"),
        "bullet": bullet_of(cache),
        "cgal": package_version("libcgal-dev"),
        "fcl": package_version("libfcl-dev"),
        "ompl": package_version("libompl-dev"),
        "compiler": said_by(cache.get("CMAKE_CXX_COMPILER", "c++"), "--version"),
        "flags": " ".join(flags.split()),
        "instruction_set": target.group(1) if target else "not known",
    }


def machine_record():
    text = pathlib.Path("/proc/cpuinfo").read_text()
    model = re.search(r"^model name\s*:\s*(.*)$", text, re.M)
    memory = re.search(r"^MemTotal:\s+(\d+) kB", pathlib.Path("/proc/meminfo").read_text(), re.M)
    return {
        "cpu": model.group(1) if model else platform.machine(),
        "cores": str(os.cpu_count()),
        "memory_gb": f"{int(memory.group(1)) / 2**20:.0f}",
    }


def now():
    return datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M")


def busy_seconds(stat):
    """The processor time that a text of /proc/stat counts as spent: by all processes, and stolen by the host."""
    user, nice, system, _idle, _wait, irq, soft, steal = (int(word) for word in stat.split("\n")[0].split()[1:9])
    return (user + nice + system + irq + soft + steal) / os.sysconf("SC_CLK_TCK")


def own_seconds():
    """The processor time of this process and of those that it started and that have ended."""
    usages = [resource.getrusage(who) for who in (resource.RUSAGE_CHILDREN, resource.RUSAGE_SELF)]
    return sum(usage.ru_utime + usage.ru_stime for usage in usages)


class Watch:
    """Measures the share of the machine's processor time that others took between begin and end: processes that this one did not
    start, and the host of a virtual machine."""

    def __init__(self):
        self.began = (time.monotonic(), self.busy(), own_seconds())

    @staticmethod
    def busy():
        return busy_seconds(pathlib.Path("/proc/stat").read_text())

    def disturbance(self):
        began, busy, ours = self.began
        seconds = time.monotonic() - began
        others = (self.busy() - busy) - (own_seconds() - ours)
        # /proc/stat counts in hundredths of a second for each processor: less than that is no disturbance.
        others = max(0.0, others - 0.02 * os.cpu_count())
        return others / (seconds * os.cpu_count()) if seconds > 0 else 0.0
