# Finds the libraries. cmake/packages.txt lists the Debian packages that hold them.

find_package(Eigen3 3.3 REQUIRED NO_MODULE)
find_package(hwy 1.0 REQUIRED CONFIG)
find_package(Boost 1.71 REQUIRED)
if(CLEARWAY_TESTS)
  find_package(Boost 1.71 REQUIRED COMPONENTS unit_test_framework)
  set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
  find_package(CGAL 5.4 REQUIRED CONFIG)  # a second opinion on the tests' oracle
endif()
find_package(TBB 2021 REQUIRED CONFIG COMPONENTS tbb)
find_package(Threads REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED CONFIG)

# Depending on their version, assimp and OMPL export variables or targets; here each gets one target. Their headers count as
# system headers, so that the compiler does not warn about them.
find_package(assimp 5 REQUIRED CONFIG)
add_library(clearway_assimp INTERFACE)
target_link_libraries(clearway_assimp INTERFACE assimp::assimp)

add_library(clearway_boost INTERFACE)
target_link_libraries(clearway_boost INTERFACE Boost::headers)

find_package(embree 4 CONFIG QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 REQUIRED CONFIG)
endif()
add_library(clearway_embree INTERFACE)
target_link_libraries(clearway_embree INTERFACE embree)
target_compile_definitions(clearway_embree INTERFACE CLEARWAY_EMBREE_MAJOR=${EMBREE_VERSION_MAJOR})

# Draws the lines and the lettering of a picture's legend; cairo-ft brings FreeType, which reads the font.
find_package(PkgConfig REQUIRED)
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo-ft>=1.16)

# The font of that lettering. It becomes part of the program, as its licence permits: pictures then have letters, and the same
# ones, on every machine.
find_file(CLEARWAY_FONT DejaVuSans.ttf REQUIRED PATHS /usr/share/fonts /usr/local/share/fonts
          PATH_SUFFIXES truetype/dejavu dejavu dejavu-sans-fonts TTF)

find_package(PNG 1.6 REQUIRED)  # writes the pictures: its simplified interface compresses an image in one call

# find_package gets no version here, because OMPL's version file says that 2.0 does not satisfy 1.5.
find_package(ompl REQUIRED CONFIG)
if(ompl_VERSION VERSION_LESS 1.5)
  message(FATAL_ERROR "OMPL is ${ompl_VERSION}, in ${ompl_DIR}, expected 1.5 or later")
endif()
add_library(clearway_ompl INTERFACE)
if(TARGET ompl::ompl)
  target_link_libraries(clearway_ompl INTERFACE ompl::ompl Threads::Threads)
else()
  target_include_directories(clearway_ompl SYSTEM INTERFACE ${OMPL_INCLUDE_DIRS})
  # omplConfig also lists ODE and serialization libraries, which only OMPL.app's programs need.
  list(FILTER OMPL_LIBRARIES INCLUDE REGEX "libompl")
  target_link_libraries(clearway_ompl INTERFACE ${OMPL_LIBRARIES} Threads::Threads)
endif()
