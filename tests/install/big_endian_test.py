"""A big-endian processor is refused by name, by CMake and by compilers without it: big_endian_test.py SOURCE WORK"""

import os
import shutil
import subprocess
import sys


def fail(message):
    sys.exit("big_endian_test: " + message)


def expect_refusal(command, *words):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    told = " ".join(done.stdout.split())
    if done.returncode == 0 or not all(word in told for word in words):
        fail("%s ended with %d, expected a refusal with %s:\n%s" % (" ".join(command), done.returncode, words, done.stdout))


def main():
    source, work = sys.argv[1:]
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    # Right after project(), as if the compiler had been found to be one for such a processor.
    pretence = os.path.join(work, "pretence.cmake")
    with open(pretence, "w") as file:
        file.write("set(CMAKE_CXX_BYTE_ORDER BIG_ENDIAN)\nset(CMAKE_SYSTEM_PROCESSOR s390x)\n")
    expect_refusal(["cmake", "-S", source, "-B", os.path.join(work, "build"), "-DCMAKE_PROJECT_clearway_INCLUDE=" + pretence],
                   "s390x is big-endian, expected a little-endian processor")
    unit = os.path.join(work, "unit.cpp")
    with open(unit, "w") as file:
        file.write("#include <clearway/types.h>\n")
    eigen = subprocess.check_output(["pkg-config", "--cflags", "eigen3"], text=True).split()
    command = ["c++", "-std=c++17", "-fsyntax-only", "-I", os.path.join(source, "include"), *eigen, unit]
    expect_refusal(command + ["-U__BYTE_ORDER__", "-D__BYTE_ORDER__=__ORDER_BIG_ENDIAN__"],
                   "this processor is big-endian, clearway expects a little-endian one")
    if subprocess.run(command).returncode != 0:
        fail("the header does not compile for this processor")


main()
