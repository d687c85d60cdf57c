"""Installs clearway and builds users' projects with it: installed_test.py BUILD SOURCE WORK

Through find_package (shared and static), pkg-config, add_subdirectory and FetchContent; every program must print the same
distance. With CLEARWAY_FULL in the environment the last two also build, which compiles the library; otherwise the first of
them configures, programs for AVX-512 and in C++20 are left out, one program, in C, is linked statically, and of the C++ programs only the
planner's is built by pkg-config.
Fails with a line that says what was expected."""

import os
import re
import shutil
import subprocess
import sys

from snippets import require_one_distance, write_snippets

kFullRun = bool(os.environ.get("CLEARWAY_FULL"))
kDistancePrograms = ("distance_plain", "distance_avx512", "distance_cxx20", "distance_c")
kPrograms = kDistancePrograms + ("planning",)
kSharedPrograms = kPrograms if kFullRun else ("distance_plain", "distance_c", "planning")
kStaticPrograms = kPrograms if kFullRun else ("distance_c",)


def fail(message):
    sys.exit("installed_test: " + message)


def output_of(*command, expected=0, **keywords):
    result = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            **keywords)
    if result.returncode != expected:
        fail("%s ended with %d, expected %d:\n%s" % (" ".join(map(str, command)), result.returncode, expected, result.stdout))
    return result.stdout


def line_of_programs(folder, programs):
    """The one line that all of the programs that ask for a distance must print."""
    kinds = [kind for kind in kDistancePrograms
             if kind in programs and ("avx512" not in kind or " avx512f " in open("/proc/cpuinfo").read())]
    lines = {kind: output_of(os.path.join(folder, kind)) for kind in kinds}
    if len(set(lines.values())) != 1:
        fail("the programs of %s print different distances: %s" % (folder, lines))
    return next(iter(lines.values()))


def libraries_of(program):
    """The names of the shared libraries that a program is linked with."""
    return re.findall(r"\[(.*)\]", "\n".join(
        line for line in output_of("readelf", "-d", program).splitlines() if "NEEDED" in line))


def configure(consumer, folder, *options, expected=0):
    kind = "Release" if kFullRun else "None"  # which takes less time to compile
    return output_of("cmake", "-S", consumer, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=" + kind, *options, expected=expected)


def check_find_package(consumer, prefix, work):
    printed = []
    for kind, components, programs in (("shared", "planning", kSharedPrograms), ("static", "static;planning", kStaticPrograms)):
        folder = os.path.join(work, kind)
        configure(consumer, folder, "-DCMAKE_PREFIX_PATH=" + prefix, "-DCLEARWAY_COMPONENTS=" + components)
        output_of("cmake", "--build", folder, "--target", *programs)
        printed.append(line_of_programs(folder, programs))
        if "planning" in programs:
            clearance, valid = output_of(os.path.join(folder, "planning")).splitlines()[-1].split()  # OMPL may print before it
            if not 1.5 - 1e-12 < float(clearance) <= 1.5 or valid != "1":  # the clearance is a lower bound
                fail("a part 2 away with a margin of 0.5 has clearance and validity %s %s, expected 1.5 1" % (clearance, valid))
        for program in programs:
            ours = [name for name in libraries_of(os.path.join(folder, program)) if "clearway" in name]
            if bool(ours) != (kind == "shared"):
                fail("%s linked as %s needs the libraries %s" % (program, kind, ours))
            if any(not re.search(r"\.so\.\d+\.\d+$", name) for name in ours):
                fail("the libraries' names are %s, expected names with a version" % ours)
    wrong = configure(consumer, os.path.join(work, "wrong"), "-DCMAKE_PREFIX_PATH=" + prefix, "-DCLEARWAY_COMPONENTS=plannign",
                      expected=1)
    if "there is no component 'plannign', expected planning or static" not in re.sub(r"\s+", " ", wrong):
        fail("a component 'plannign' is refused with: " + wrong)
    check_several_find_packages(prefix, work)
    return printed


def check_several_find_packages(prefix, work):
    """A program has one kind of libraries, and a component that is optional need not be there."""
    source = os.path.join(work, "several")
    os.makedirs(source)
    with open(os.path.join(source, "CMakeLists.txt"), "w") as file:
        file.write("cmake_minimum_required(VERSION 3.25)\nproject(several LANGUAGES CXX)\n"
                   "foreach(arguments IN LISTS CALLS)\n"
                   "  separate_arguments(arguments)\n"
                   "  find_package(clearway CONFIG REQUIRED ${arguments})\n"
                   "endforeach()\n"
                   "foreach(target clearway planning)\n"
                   "  get_target_property(type clearway::${target} TYPE)\n"
                   "  message(STATUS \"${target} is ${type}\")\n"
                   "endforeach()\n"
                   "message(STATUS \"foo is ${clearway_foo_FOUND}\")\n")
    for calls, status, words in (
            ("COMPONENTS static;COMPONENTS planning", 0, ("clearway is STATIC_LIBRARY", "planning is STATIC_LIBRARY")),
            ("COMPONENTS clearway;OPTIONAL_COMPONENTS planning foo", 0,
             ("clearway is SHARED_LIBRARY", "planning is SHARED_LIBRARY", "foo is FALSE")),
            ("COMPONENTS planning;COMPONENTS static", 1, ("the shared libraries were found before, expected the component static",))):
        folder = os.path.join(source, "build")
        told = re.sub(r"\s+", " ", configure(source, folder, "-DCMAKE_PREFIX_PATH=" + prefix, "-DCALLS=" + calls, expected=status))
        shutil.rmtree(folder)
        for text in words:
            if text not in told:
                fail("find_package of '%s' says: %s, expected: %s" % (calls, told, text))


def check_project_in_c(consumer, prefix, work):
    """A CMake project in C alone links the shared library; the static one needs C++'s linker."""
    source = os.path.join(work, "in_c_alone")
    os.makedirs(source)
    with open(os.path.join(source, "CMakeLists.txt"), "w") as file:
        file.write("cmake_minimum_required(VERSION 3.25)\nproject(in_c_alone LANGUAGES C)\n"
                   "find_package(clearway 0.2 CONFIG REQUIRED COMPONENTS ${CLEARWAY_COMPONENTS})\n"
                   "add_executable(distance %s/distance.c)\n"
                   "target_link_libraries(distance PRIVATE clearway::clearway)\n" % consumer)
    folder = os.path.join(source, "build")
    configure(source, folder, "-DCMAKE_PREFIX_PATH=" + prefix)
    output_of("cmake", "--build", folder)
    told = configure(source, folder, "-DCMAKE_PREFIX_PATH=" + prefix, "-DCLEARWAY_COMPONENTS=static", expected=1)
    if "the project's languages are C, expected CXX among them" not in re.sub(r"\s+", " ", told):
        fail("in a project in C alone the static library is refused with: " + told)
    return output_of(os.path.join(folder, "distance"))


def check_pkg_config(consumer, prefix, work):
    environment = dict(os.environ, PKG_CONFIG_PATH=os.path.join(prefix, "lib", "pkgconfig"),
                       LD_LIBRARY_PATH=os.path.join(prefix, "lib"))
    for name in ("clearway", "clearway-planning"):
        output_of("pkg-config", "--exists", "--print-errors", name, env=environment)
    flags = output_of("pkg-config", "--cflags", "--libs", "clearway", env=environment).split()
    program = os.path.join(work, "by_pkg_config")
    output_of("cc", "-std=c99", os.path.join(consumer, "distance.c"), "-o", program + "_in_c", *flags)
    printed = [output_of(program + "_in_c", env=environment)]
    if kFullRun:
        output_of("c++", "-std=c++17", os.path.join(consumer, "distance.cpp"), "-o", program, *flags)
        printed.append(output_of(program, env=environment))
    # OMPL 1.5's own file names libraries of Boost and an older C++. Neither is asked of who uses clearway.
    flags = output_of("pkg-config", "--cflags", "--libs", "clearway-planning", env=environment).split()
    if [flag for flag in flags if flag.startswith("-std") or "boost" in flag]:
        fail("clearway-planning.pc asks for a language, or for Boost's libraries: " + " ".join(flags))
    output_of("c++", "-std=c++17", os.path.join(consumer, "planning.cpp"), "-o", program + "_planning", *flags)
    if not output_of(program + "_planning", env=environment).endswith(" 1\n"):
        fail("the program of clearway-planning.pc calls a valid state invalid")
    return printed


def check_pkg_config_static(consumer, prefix, work):
    """Where there is no shared library, pkg-config names what the static one needs, for C programs too."""
    alone = os.path.join(work, "static_alone")
    shutil.copytree(prefix, alone, ignore=lambda folder, names: [name for name in names if ".so" in name], symlinks=True)
    environment = dict(os.environ, PKG_CONFIG_PATH=os.path.join(alone, "lib", "pkgconfig"))
    flags = output_of("pkg-config", "--static", "--cflags", "--libs", "clearway", env=environment).split()
    program = os.path.join(work, "in_c_static")
    output_of("cc", "-std=c99", os.path.join(consumer, "distance.c"), "-o", program, *flags)
    if any("clearway" in name for name in libraries_of(program)):
        fail("linked without shared libraries a program needs %s" % libraries_of(program))
    return output_of(program)


def check_part_of_a_build(consumer, source, work, way, own_line):
    folder = os.path.join(work, way)
    options = ["-DCLEARWAY_FROM=" + way, "-DCLEARWAY_SOURCE=" + source, "-DCLEARWAY_SCALAR_ONLY=ON"]
    told = configure(consumer, folder, *options)
    if "CGAL" in told or os.path.exists(os.path.join(folder, "clearway", "tests")):
        fail("as a part of another build (%s) clearway configures its tests:\n%s" % (way, told))
    if kFullRun:
        output_of("cmake", "--build", folder, "--target", *kDistancePrograms)
        # An instruction set may change the last digits.
        if abs(float(line_of_programs(folder, kDistancePrograms)) - float(own_line)) > 1e-14:
            fail("built as a part of another build (%s), the distance differs" % way)


def check_snippets(source, prefix, work):
    """The complete programs of docs/coming_from.md run, and agree."""
    folder = os.path.join(work, "snippets")
    os.makedirs(folder)
    environment = dict(os.environ, PATH="/usr/bin:" + os.environ["PATH"], CMAKE_PREFIX_PATH=prefix, CMAKE_GENERATOR="Ninja",
                       PKG_CONFIG_PATH=os.path.join(prefix, "lib", "pkgconfig"), LD_LIBRARY_PATH=os.path.join(prefix, "lib"),
                       PYTHONPATH=os.path.join(prefix, "lib", "python3", "dist-packages"), PYTHONDONTWRITEBYTECODE="1")
    require_one_distance([output_of("bash", "-c", command, cwd=folder, env=environment)
                          for command in write_snippets(source, folder)])


def check_where_libraries_look(prefix):
    """Libraries find each other beside themselves, wherever the tree lies, and hold no path of the build."""
    module = os.path.join(prefix, "lib", "python3", "dist-packages", "clearway")
    extensions = [os.path.join(module, name) for name in os.listdir(module) if name.endswith(".so")]
    for library in [os.path.join(prefix, "lib", "libclearway-planning.so")] + extensions:
        told = output_of("ldd", library)
        found = [os.path.dirname(os.path.realpath(path)) for path in re.findall(r"libclearway\.so\S* => (\S+)", told)]
        if found != [os.path.realpath(os.path.join(prefix, "lib"))]:
            fail("%s does not find libclearway in its own installation:\n%s" % (library, told))
        for path in re.findall(r"R(?:UN)?PATH.*\[(.*)\]", output_of("readelf", "-d", library)):
            if not path.startswith("$ORIGIN"):
                fail("%s looks for libraries in %s, expected a path that begins with $ORIGIN" % (library, path))


def files_below(folder):
    return {os.path.relpath(os.path.join(at, name), folder) for at, _, names in os.walk(folder) for name in names}


def check_components(build, prefix, work):
    """Each file belongs to one component; programs that use the library alone need one library."""
    names = ("libclearway", "libclearway-planning", "libclearway-dev", "clearway-tools", "clearway-cad", "python3-clearway")
    files = {}
    for name in names:
        folder = os.path.join(work, "components", name)
        output_of("cmake", "--install", build, "--component", name, "--prefix", folder)
        files[name] = files_below(folder)
    missing = files_below(prefix).symmetric_difference(set().union(*files.values()))
    if missing or sum(map(len, files.values())) != len(files_below(prefix)):
        fail("components differ from the whole installation by %s, or hold a file twice" % sorted(missing))
    for name in names[:2]:
        if any("lib/%s.so." % name not in file and "LICENSE" not in file for file in files[name]):
            fail("the component %s holds %s, expected its library alone" % (name, sorted(files[name])))


def check_without(source, work):
    """The library alone needs neither OMPL nor libpng, cairo and Embree; a target that cannot be had is named."""
    missing = ["-DCMAKE_DISABLE_FIND_PACKAGE_%s=ON" % name for name in ("ompl", "PNG", "PkgConfig", "embree")]
    only = ["-DCLEARWAY_%s=OFF" % name for name in ("PLANNING", "PROGRAM", "EMBREE", "TESTS", "DEMOS")]
    alone = os.path.join(work, "library_alone")
    configure(source, alone, *missing, *only)
    told = configure(os.path.join(source, "tests", "install", "consumer"), os.path.join(work, "planning_left_out"),
                     "-Dclearway_DIR=" + os.path.join(alone, "generated"), "-DCLEARWAY_COMPONENTS=planning", expected=1)
    if "this clearway was built without its component planning (CLEARWAY_PLANNING=OFF)" not in re.sub(r"\s+", " ", told):
        fail("a component that was left out is refused with: " + told)
    for options, named in ((only[1:], "clearway::planning needs OMPL 1.5 or later"),
                           (only[:2] + only[3:], "clearway::clearway needs Embree 3 or 4"),
                           (only[:1] + only[2:], "CLEARWAY_PROGRAM is ON and CLEARWAY_PLANNING is OFF"),
                           (only + ["-DCMAKE_INSTALL_LIBDIR=/lib64"], "CMAKE_INSTALL_LIBDIR is /lib64, expected a folder below the prefix")):
        told = re.sub(r"\s+", " ", configure(source, os.path.join(work, "refused"), *missing, *options, expected=1))
        if named not in told:
            fail("expected '%s' in: %s" % (named, told))
        shutil.rmtree(os.path.join(work, "refused"))


def check_symbols(prefix):
    """A shared library shows what the public headers declare, in C++ and in C, and no type whose alignment depends on
    compiler options."""
    for name, internal in (("clearway", r"clearway::buildBySah|clearway::Solid::|nlohmann::|[Aa]ssimp|hwy::"),
                           ("clearway-planning", r"clearway::planning::MotionSweep|nlohmann::")):
        library = os.path.join(prefix, "lib", "lib%s.so" % name)
        symbols = output_of("nm", "--dynamic", "--defined-only", "--demangle", library)
        if "clearway::" not in symbols:
            fail("%s shows no symbol" % library)
        declared = set(re.findall(r"\bclearway_\w+(?=\()", open(os.path.join(prefix, "include/clearway/clearway.h")).read()))
        shown = set(re.findall(r" T (clearway_\w+)$", symbols, re.M))
        if name == "clearway" and (len(declared) < 10 or shown != declared):
            fail("%s shows to C %s, expected what clearway.h declares: %s" % (library, sorted(shown), sorted(declared)))
        for line in symbols.splitlines():
            if re.search(internal, line):
                fail("%s shows an internal symbol: %s" % (library, line))
            if re.search(r"Eigen::(Transform|Quaternion|Translation)<", line):
                fail("%s shows a symbol that names a type of Eigen's with uncertain alignment: %s" % (library, line))


def check_program(prefix):
    program = os.path.join(prefix, "bin", "clearway")
    version = output_of(program, "--version").splitlines()[0]
    subcommands = re.findall(r"^  ([a-z]+)  +", output_of(program, "--help"), re.M)
    pages = {"clearway.1", "clearway-scene.1"} | {"clearway-%s.1" % name for name in subcommands}
    if os.path.exists(os.path.join(prefix, "bin", "clearway-cad")):  # built where OpenCASCADE is found
        pages.add("clearway-cad.1")
    installed = set(os.listdir(os.path.join(prefix, "share", "man", "man1")))
    if len(pages) < 8 or installed != pages:
        fail("man pages are %s, expected %s" % (sorted(installed), sorted(pages)))
    completion = open(os.path.join(prefix, "share", "bash-completion", "completions", "clearway")).read()
    if "complete -o default -F _clearway clearway" not in completion or not re.match(r"clearway \d+\.\d+\.\d+$", version):
        fail("the completion or the version (%s) is not the program's" % version)


def main():
    build, source, work = sys.argv[1:]
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    prefix = os.path.join(work, "prefix")
    consumer = os.path.join(source, "tests", "install", "consumer")
    # Packages are made so: installed for one place, staged in another. The tree works wherever it lies.
    stage = os.path.join(work, "stage")
    output_of("cmake", "--install", build, "--prefix", "/opt/clearway", env=dict(os.environ, DESTDIR=stage))
    os.rename(stage + "/opt/clearway", prefix)
    printed = check_find_package(consumer, prefix, work)
    printed.append(check_project_in_c(consumer, prefix, work))
    printed += check_pkg_config(consumer, prefix, work)
    printed.append(check_pkg_config_static(consumer, prefix, work))
    if len(set(printed)) != 1:
        fail("the installed libraries' distances differ: %s" % printed)
    for way in ("add_subdirectory", "FetchContent") if kFullRun else ("add_subdirectory",):
        check_part_of_a_build(consumer, source, work, way, printed[0])
    check_without(source, work)
    check_snippets(source, prefix, work)
    check_where_libraries_look(prefix)
    check_components(build, prefix, work)
    check_symbols(prefix)
    check_program(prefix)


main()
