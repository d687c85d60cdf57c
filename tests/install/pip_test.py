"""Installs the Python module by pip in a virtual environment and plans there: pip_test.py SOURCE WORK

That compiles the library, so that it is done only with CLEARWAY_FULL in the environment; otherwise what pip would build is configured.
Fails with a line that says what was expected."""

import os
import shutil
import subprocess
import sys

kPlan = """
import clearway, clearway.planning, sys
assert clearway.__file__.startswith(sys.prefix), clearway.__file__
planned = clearway.planning.plan(sys.argv[1], planner="SlidingRRTConnect", iterations=20000, quick=True)
print(bool(planned and clearway.planning.check(sys.argv[1], planned)))
"""
# Stands in for scikit-build and prints what it would give to CMake.
kArguments = """
import runpy, sys, types
sys.modules["skbuild"] = types.SimpleNamespace(setup=lambda **given: print("\\n".join(given["cmake_args"])))
runpy.run_path(sys.argv[1])
"""


def fail(message):
    sys.exit("pip_test: " + message)


def output_of(*command, **keywords):
    result = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **keywords)
    if result.returncode != 0:
        fail("%s ended with %d, expected 0:\n%s" % (" ".join(map(str, command)), result.returncode, result.stdout))
    return result.stdout


def check_configuration(source, work):
    """With and without OMPL."""
    options = output_of(sys.executable, "-c", kArguments, os.path.join(source, "setup.py")).split()
    for hidden, is_planning in ((False, True), (True, False)):
        folder = os.path.join(work, "without_ompl" if hidden else "with_ompl")
        output_of("cmake", "-S", source, "-B", folder, "-G", "Ninja", "-DPython3_EXECUTABLE=" + sys.executable,
                  "-DCMAKE_DISABLE_FIND_PACKAGE_ompl=%s" % hidden, *options)
        targets = output_of("cmake", "--build", folder, "--target", "help")
        if "clearway_python:" not in targets or ("clearway_python_planning:" in targets) != is_planning:
            fail("%s OMPL pip would build:\n%s" % ("without" if hidden else "with", targets))


def check_installation(source, work):
    copy = os.path.join(work, "source")
    os.makedirs(copy)
    for name in ("CMakeLists.txt", "LICENSE", "README.md", "pyproject.toml", "setup.py"):
        shutil.copy(os.path.join(source, name), copy)
    for name in ("cmake", "include", "python", "src"):
        shutil.copytree(os.path.join(source, name), os.path.join(copy, name), ignore=shutil.ignore_patterns("__pycache__"))
    environment = os.path.join(work, "venv")
    output_of(sys.executable, "-m", "venv", "--system-site-packages", environment)
    output_of(os.path.join(environment, "bin", "pip"), "install", "--no-build-isolation", ".", cwd=copy)
    shutil.rmtree(copy)  # what is installed needs nothing of it
    clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    bracket = os.path.join(source, "data", "bracket", "bracket.cfg")
    if output_of(os.path.join(environment, "bin", "python"), "-c", kPlan, bracket, env=clean, cwd=work).strip() != "True":
        fail("a plan in the virtual environment did not pass its check")


def main():
    source, work = sys.argv[1:]
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    check_configuration(source, work)
    if os.environ.get("CLEARWAY_FULL"):
        check_installation(source, work)


main()
