# Finds the libraries. cmake/packages.txt lists the Debian packages that hold them.

# need(TARGET WHAT FOUND PACKAGE CURE): says by name which target cannot be had, and what to do.
function(need target what found package remedy)
  if(NOT ${found})
    message(FATAL_ERROR "${target} needs ${what}, which was not found. Debian's package is ${package}; ${remedy}")
  endif()
endfunction()
# need_package(TARGET WHAT NAME VERSION PACKAGE CURE [OPTION...]): finds a package that CMake knows as NAME.
macro(need_package target what name version package remedy)
  find_package(${name} ${version} QUIET ${ARGN})
  need(${target} "${what} ${version} or later" ${name}_FOUND ${package} "${remedy}")
endmacro()
set(elsewhere "CMAKE_PREFIX_PATH names other places to look in")
if(POLICY CMP0167)
  cmake_policy(SET CMP0167 NEW)  # Boost's own CMake files find it, not CMake's module
endif()

need_package(clearway::clearway Eigen Eigen3 3.3 libeigen3-dev "${elsewhere}" NO_MODULE)
need_package(clearway::clearway Highway hwy 1.0 libhwy-dev "${elsewhere}" CONFIG)
need_package(clearway::clearway Boost Boost 1.71 libboost-dev "${elsewhere}")
need_package(clearway::clearway oneTBB TBB 2021 libtbb-dev "${elsewhere}" CONFIG COMPONENTS tbb)
need_package(clearway::clearway "the formatting library fmt" fmt 9 libfmt-dev "${elsewhere}" CONFIG)  # its headers alone: programs need no library of it
need_package(clearway::clearway "nlohmann's JSON library" nlohmann_json 3.11 nlohmann-json3-dev "${elsewhere}" CONFIG)
need_package(clearway::clearway assimp assimp 5 libassimp-dev "${elsewhere}" CONFIG)
need_package(clearway::clearway pugixml pugixml 1.12 libpugixml-dev "${elsewhere}" CONFIG)  # reads the XML of 3MF and COLLADA files
find_path(ZIP_INCLUDE_DIR zip.h)  # libzip, which unpacks 3MF files; Debian 12's CMake files of it name tools that its package lacks
find_library(ZIP_LIBRARY zip)
need(clearway::clearway libzip ZIP_LIBRARY libzip-dev "${elsewhere}")
need(clearway::clearway "libzip's header zip.h" ZIP_INCLUDE_DIR libzip-dev "${elsewhere}")
if(CLEARWAY_EMBREE)
  find_package(embree 4 CONFIG QUIET)
  if(NOT embree_FOUND)
    find_package(embree 3 CONFIG QUIET)
  endif()
  need(clearway::clearway "Embree 3 or 4" embree_FOUND libembree-dev "-DCLEARWAY_EMBREE=OFF does without (and without the program)")
endif()
if(CLEARWAY_PLANNING)
  include(${CMAKE_CURRENT_LIST_DIR}/find_ompl.cmake)
  need(clearway::planning "OMPL 1.5 or later" clearway_ompl_FOUND libompl-dev
       "${clearway_ompl_fault}-Dompl_DIR=DIR names a folder that holds omplConfig.cmake, and -DCLEARWAY_PLANNING=OFF does without OMPL")
endif()

if(CLEARWAY_PROGRAM)
  set(without "-DCLEARWAY_PROGRAM=OFF leaves the program out")
  # Draws the lines and the lettering of a picture's legend; cairo-ft brings FreeType, which reads the font.
  find_package(PkgConfig QUIET)
  need("the program" pkg-config PkgConfig_FOUND pkg-config "${without}")
  pkg_check_modules(CAIRO QUIET IMPORTED_TARGET cairo-ft>=1.16)
  need("the program" "cairo 1.16 or later" CAIRO_FOUND libcairo2-dev "${without}")
  # The font of that lettering. It becomes part of the program, as its licence permits: pictures then have letters, and the same
  # ones, on every machine.
  find_file(CLEARWAY_FONT DejaVuSans.ttf PATHS /usr/share/fonts /usr/local/share/fonts
            PATH_SUFFIXES truetype/dejavu dejavu dejavu-sans-fonts TTF)
  need("the program" "the font DejaVuSans.ttf" CLEARWAY_FONT fonts-dejavu-core "${without}")
  need_package("the program" libpng PNG 1.6 libpng-dev "${without}")  # writes the pictures: compresses an image in one call
  # Makes meshes of STEP and IGES files, for clearway-cad alone.
  set(OpenCASCADE_FOUND FALSE)
  if(CLEARWAY_CAD AND NOT (CLEARWAY_CAD STREQUAL "AUTO" AND CMAKE_CROSSCOMPILING))
    find_package(OpenCASCADE QUIET COMPONENTS FoundationClasses ModelingData ModelingAlgorithms Visualization ApplicationFramework DataExchange)
    set(cad_libraries TKXCAF TKMesh)
    if(TARGET TKDESTEP AND TARGET TKDEIGES)
      list(APPEND cad_libraries TKDESTEP TKDEIGES)
    elseif(TARGET TKXDESTEP AND TARGET TKXDEIGES)
      list(APPEND cad_libraries TKXDESTEP TKXDEIGES TKSTEP TKIGES)
    else()
      set(OpenCASCADE_FOUND FALSE)
    endif()
    if("${OpenCASCADE_MAJOR_VERSION}.${OpenCASCADE_MINOR_VERSION}" VERSION_LESS 7.6)
      set(OpenCASCADE_FOUND FALSE)
    endif()
    if(NOT CLEARWAY_CAD STREQUAL "AUTO")
      need("clearway-cad" "OpenCASCADE 7.6 or later" OpenCASCADE_FOUND libocct-data-exchange-dev "-DCLEARWAY_CAD=OFF does without; ${elsewhere}")
    endif()
  endif()
  # Lets `clearway bench` run under mpirun. FindMPI would ask the host's compiler wrapper about another machine's library.
  set(MPI_CXX_FOUND FALSE)
  if(CLEARWAY_MPI AND NOT (CLEARWAY_MPI STREQUAL "AUTO" AND CMAKE_CROSSCOMPILING))
    set(MPI_CXX_SKIP_MPICXX ON)  # only the functions for C are used
    find_package(MPI 3 QUIET COMPONENTS CXX)
    if(NOT CLEARWAY_MPI STREQUAL "AUTO")
      need("`clearway bench` under mpirun" "MPI 3 or later" MPI_CXX_FOUND libopenmpi-dev "-DCLEARWAY_MPI=OFF does without; ${elsewhere}")
    endif()
  endif()
endif()

if(CLEARWAY_TESTS)
  set(without "-DCLEARWAY_TESTS=OFF leaves the tests out")
  find_package(Boost 1.71 QUIET COMPONENTS unit_test_framework)
  need("the tests" "Boost.Test 1.71 or later" Boost_UNIT_TEST_FRAMEWORK_FOUND libboost-test-dev "${without}")
  set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
  find_package(CGAL 5.4 QUIET CONFIG)  # a second opinion on the tests' oracle
  need("the tests" "CGAL 5.4 or later, with GMP and MPFR" CGAL_FOUND "libcgal-dev with libgmp-dev and libmpfr-dev" "${without}")
  if(CLEARWAY_PROGRAM AND CLEARWAY_DEMOS)
    need_package("the benchmarks" FCL fcl 0.7 libfcl-dev "${without}" CONFIG)  # benchmarks measure against it
  endif()
endif()
