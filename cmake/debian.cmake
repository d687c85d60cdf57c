# `cpack` makes Debian packages, one for each component of the install target: the preset `deb` configures for them. Packages are
# made only where libraries are shared and go to /usr. dpkg-shlibdeps finds their dependencies outside of clearway.

if(NOT BUILD_SHARED_LIBS OR NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  return()
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has a summary of its own
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SOURCE clearway)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR})  # clearway's own libraries; ENABLE_COMPONENT_DEPENDS names them
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)                           # with the packages' exact version
# Debian's convention: the environment names who makes the packages.
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The clearway authors <authors@clearway.invalid>")
if(DEFINED ENV{DEBFULLNAME} AND DEFINED ENV{DEBEMAIL})
  set(CPACK_DEBIAN_PACKAGE_MAINTAINER "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif()

# add_package(NAME SECTION DESCRIPTION [COMPONENT...]): the package of the component NAME, which depends on those of the other components.
set(CPACK_COMPONENTS_ALL "")
macro(add_package name section description)
  list(APPEND CPACK_COMPONENTS_ALL ${name})
  string(TOUPPER ${name} upper_name)
  set(CPACK_DEBIAN_${upper_name}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${upper_name}_PACKAGE_SECTION ${section})
  set(CPACK_COMPONENT_${upper_name}_DESCRIPTION "${description}")
  set(CPACK_COMPONENT_${upper_name}_DEPENDS ${ARGN})
endmacro()

# add_library_package(NAME ...): add_package of a shared library. Its control files make dpkg update the linker's cache, and tell
# packages of programs that link the library what to depend on.
set(debian ${generated}/debian)
macro(add_library_package name)
  add_package(${name} libs ${ARGN})
  file(WRITE ${debian}/${name}/triggers "activate-noawait ldconfig\n")
  file(WRITE ${debian}/${name}/shlibs
       "${name} ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} ${name} (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})\n")
  set(CPACK_DEBIAN_${upper_name}_PACKAGE_CONTROL_EXTRA ${debian}/${name}/triggers ${debian}/${name}/shlibs)
endmacro()

# Python's compiled modules come and go with the package.
file(WRITE ${debian}/postinst "#!/bin/sh\nset -e\nif [ \"$1\" = configure ]; then py3compile -p python3-clearway; fi\n")
file(WRITE ${debian}/prerm "#!/bin/sh\nset -e\npy3clean -p python3-clearway\n")

add_library_package(libclearway "Exact distance and contact queries for triangle meshes
clearway answers distance, contact and tolerance queries between rigid
parts given as triangle meshes, and certifies whole motions of a part.
It searches SIMD trees of rectangle swept spheres.")

# OMPL stays away from who has no use for it: its classes are in a package of their own, and libclearway-dev only suggests it.
if(CLEARWAY_PLANNING)
  add_library_package(libclearway-planning "Validity checks and certified motions of clearway for OMPL
This library holds a validity checker, a certifying motion validator,
clearance objectives and planners for the Open Motion Planning Library." libclearway)
endif()

add_package(libclearway-dev libdevel "Exact distance and contact queries (development files)
Headers, static libraries and the files through which CMake and
pkg-config find clearway. The component planning needs the packages
libclearway-planning and libompl-dev. Static linking needs libassimp-dev,
libembree-dev, libhwy-dev, libpugixml-dev, libtbb-dev and libzip-dev." libclearway)
set(CPACK_DEBIAN_LIBCLEARWAY-DEV_PACKAGE_DEPENDS libeigen3-dev)
set(CPACK_DEBIAN_LIBCLEARWAY-DEV_PACKAGE_SUGGESTS
    "libclearway-planning, libompl-dev, libassimp-dev, libembree-dev, libhwy-dev, libpugixml-dev, libtbb-dev, libzip-dev")

if(CLEARWAY_PROGRAM)
  add_package(clearway-tools science "Plans and checks motions of a rigid part in a tight assembly
The program clearway plans paths with OMPL for a rigid part, checks and
shortens paths with certified clearance, and draws pictures and reports
of them. It answers problem files that OMPL.app wrote, too.
clearway-scene makes demo scenes.")
endif()

# OpenCASCADE stays away from who has no STEP files.
if(TARGET clearway_cad_program)
  add_package(clearway-cad science "Makes meshes of STEP and IGES files for clearway
The program clearway-cad makes a 3MF file of a STEP or IGES file with
OpenCASCADE: a named mesh for each part of an assembly, in its place, in
double. `clearway init` calls it where it is installed.")
  set(CPACK_DEBIAN_CLEARWAY-CAD_PACKAGE_SUGGESTS clearway-tools)
endif()

if(CLEARWAY_PYTHON)
  find_package(Python3 COMPONENTS Interpreter QUIET)
  set(libraries libclearway)
  if(TARGET clearway_python_planning)
    list(APPEND libraries libclearway-planning)
  endif()
  math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
  add_package(python3-clearway python "Exact distance and contact queries for triangle meshes (Python)
The Python module clearway answers distance, contact and tolerance
queries between triangle meshes, on numpy arrays of poses, and certifies
motions. clearway.planning plans and checks paths with OMPL." ${libraries})
  set(CPACK_DEBIAN_PYTHON3-CLEARWAY_PACKAGE_DEPENDS
      "python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}), python3 (<< ${Python3_VERSION_MAJOR}.${next_minor}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON3-CLEARWAY_PACKAGE_CONTROL_EXTRA ${debian}/postinst ${debian}/prerm)
endif()

# Debian wants a changelog and a copyright file of each package; an installation elsewhere has no use for them.
string(TIMESTAMP today "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${debian}/changelog "clearway (${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * The packages of clearway ${PROJECT_VERSION}.

 -- ${CPACK_DEBIAN_PACKAGE_MAINTAINER}  ${today}
")
set(CPACK_CLEARWAY_SOURCE ${PROJECT_SOURCE_DIR})
set(CPACK_CLEARWAY_CHANGELOG ${debian}/changelog)
set(CPACK_CLEARWAY_FONT_COPYRIGHT /usr/share/doc/fonts-dejavu-core/copyright)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/debian_stage.cmake)
include(CPack)
