#!/usr/bin/env python3
"""only_packages_test.py ROOT SCRATCH: what demos/run and plain CMake configure needs no package but those of cmake/packages.txt.

Without root or overlayfs it says that it was skipped. A project that needs what only the tests' packages hold shows that the check fails."""

import os
import shutil
import subprocess
import sys

ROOT, SCRATCH = (os.path.abspath(path) for path in sys.argv[1:3])
TOOL = os.path.join(ROOT, "tests/install/only_packages")
LIST = os.path.join(ROOT, "cmake/packages.txt")
NEEDY = """cmake_minimum_required(VERSION 3.25)
project(needy LANGUAGES NONE)
find_program(FORMAT clang-format REQUIRED)
find_package(fcl REQUIRED CONFIG)
"""
CONFIGURE = """
cmake -S needy -B needy/build && echo "the needy project was configured, expected an error" && exit 1
set -e
cmake -Wno-dev -S "$ROOT" --preset release -B demos
cmake -Wno-dev -S "$ROOT" -B plain
"""

shutil.rmtree(SCRATCH, ignore_errors=True)
os.makedirs(SCRATCH + "/needy")
with open(SCRATCH + "/needy/CMakeLists.txt", "w") as file:
    file.write(NEEDY)
command = [sys.executable, TOOL, LIST, "env", "ROOT=" + ROOT, "bash", "-c", CONFIGURE]
done = subprocess.run(command, cwd=SCRATCH, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
shutil.rmtree(SCRATCH)
if done.returncode == 77:
    print("skipped: install/only_packages was not tried: " + done.stdout.strip())
elif done.returncode != 0:
    sys.exit("where only the packages of cmake/packages.txt are installed:\n" + done.stdout)
else:
    print("demos/run and plain CMake configure with the packages of cmake/packages.txt alone")
