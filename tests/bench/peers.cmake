# The peers of the benchmark: FCL and CGAL always, Bullet if it is installed, PQP and Coal if the user gives a checkout
# or an install of theirs. Nothing of theirs is in this repository, and nothing is fetched. See README.md in this folder.

set(CLEARWAY_BENCH_PQP "" CACHE PATH "A checkout of PQP to measure against; empty for none")
set(CLEARWAY_BENCH_PQP_FLAGS "-O3" CACHE STRING "Flags that PQP is compiled with")
set(CLEARWAY_BENCH_COAL "" CACHE PATH "The prefix Coal is installed under, to measure against; empty for none")

target_sources(clearway_bench_support PRIVATE bench/peers.cpp bench/fcl_peer.cpp bench/fcl_planning.cpp)
target_link_libraries(clearway_bench_support PRIVATE fcl)

if(CLEARWAY_BENCH_PQP)
  set(pqp ${CLEARWAY_BENCH_PQP}/src)
  if(NOT EXISTS ${pqp}/PQP.h)
    message(FATAL_ERROR "CLEARWAY_BENCH_PQP is '${CLEARWAY_BENCH_PQP}', expected a folder with src/PQP.h")
  endif()
  add_library(bench_pqp STATIC ${pqp}/Build.cpp ${pqp}/BV.cpp ${pqp}/PQP.cpp ${pqp}/TriDist.cpp)
  target_include_directories(bench_pqp SYSTEM PUBLIC ${pqp})
  # These flags replace clearway's own options, some of which would slow PQP down.
  separate_arguments(pqp_flags UNIX_COMMAND "${CLEARWAY_BENCH_PQP_FLAGS}")
  set_property(TARGET bench_pqp PROPERTY COMPILE_OPTIONS ${pqp_flags} -w)
  target_sources(clearway_bench_support PRIVATE bench/pqp_peer.cpp)
  target_compile_definitions(clearway_bench_support PRIVATE CLEARWAY_BENCH_WITH_PQP)
  target_link_libraries(clearway_bench_support PRIVATE bench_pqp)
endif()

if(CLEARWAY_BENCH_COAL)
  find_package(coal 3 REQUIRED CONFIG PATHS ${CLEARWAY_BENCH_COAL} NO_DEFAULT_PATH)
  target_sources(clearway_bench_support PRIVATE bench/coal_peer.cpp)
  target_compile_definitions(clearway_bench_support PRIVATE CLEARWAY_BENCH_WITH_COAL)
  target_link_libraries(clearway_bench_support PRIVATE coal::coal)
endif()

# add_peer(NAME): compiles NAME_peer.cpp with options that must not reach clearway's code: optimised for measuring, not for tests.
function(add_peer name)
  set(target bench_${name}_peer)
  add_library(${target} OBJECT bench/${name}_peer.cpp)
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/include)
  target_link_libraries(${target} PRIVATE clearway_warnings Eigen3::Eigen)
  target_compile_options(${target} PRIVATE $<IF:$<CONFIG:Release>,-O3,-Og>)
  string(TOUPPER ${name} upper)
  target_compile_definitions(clearway_bench_support PRIVATE CLEARWAY_BENCH_WITH_${upper})
  target_link_libraries(clearway_bench_support PRIVATE ${target})
endfunction()

# Nearly all of CGAL is headers: without its assertions, in every build.
add_peer(cgal)
target_compile_definitions(bench_cgal_peer PRIVATE CGAL_NDEBUG)
target_link_libraries(bench_cgal_peer PRIVATE CGAL::CGAL)
target_link_libraries(clearway_bench_support PRIVATE gmp mpfr)

# Debian has Bullet in float and in double; the file's name chooses double.
find_package(Bullet QUIET CONFIG CONFIGS BulletConfig-float64.cmake)
if(Bullet_FOUND)
  add_peer(bullet)
  target_include_directories(bench_bullet_peer SYSTEM PRIVATE ${BULLET_ROOT_DIR}/${BULLET_INCLUDE_DIR})
  target_compile_options(bench_bullet_peer PRIVATE ${BULLET_DEFINITIONS})
  foreach(library BulletCollision-float64 LinearMath-float64)
    find_library(CLEARWAY_${library} ${library} HINTS ${BULLET_ROOT_DIR}/${BULLET_LIBRARY_DIRS} REQUIRED)
    target_link_libraries(clearway_bench_support PRIVATE ${CLEARWAY_${library}})
  endforeach()
else()
  message(STATUS "Bullet in double is not installed (libbullet-dev): the benchmarks leave it out")
endif()
