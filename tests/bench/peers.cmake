# The peers of the benchmark: FCL and CGAL always, Bullet where it is installed, PQP, Coal and MeshLib if the user gives a checkout or
# an install of theirs. Nothing of theirs is in this repository, and nothing is fetched. See README.md in this folder.

set(CLEARWAY_BENCH_PQP "" CACHE PATH "A checkout of PQP to measure against; empty for none")
set(CLEARWAY_BENCH_PQP_FLAGS "-O3" CACHE STRING "Flags that PQP is compiled with")
set(CLEARWAY_BENCH_MESHLIB "" CACHE PATH "The prefix MeshLib is installed under, to measure against; empty for none")
set(CLEARWAY_BENCH_COAL "" CACHE PATH "The prefix Coal is installed under, to measure against; empty for none")

find_package(fcl 0.7 REQUIRED CONFIG)
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

# add_header_peer(NAME LIBRARY): a peer whose templates are compiled here, without options of clearway's that would slow it down or
# warn of its headers.
function(add_header_peer name library)
  add_library(bench_${name} OBJECT bench/${name}_peer.cpp)
  target_include_directories(bench_${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/include)
  target_link_libraries(bench_${name} PRIVATE ${library} Eigen3::Eigen)
  target_compile_features(bench_${name} PRIVATE cxx_std_17)
  target_compile_options(bench_${name} PRIVATE $<IF:$<CONFIG:Release>,-O3,-O0> -w)
  target_sources(clearway_bench_support PRIVATE $<TARGET_OBJECTS:bench_${name}>)
  target_link_libraries(clearway_bench_support PRIVATE ${library})
endfunction()

add_header_peer(cgal CGAL::CGAL)
if(CLEARWAY_BENCH_MESHLIB)
  find_package(MeshLib REQUIRED CONFIG NAMES MeshLib meshlib PATHS ${CLEARWAY_BENCH_MESHLIB} NO_DEFAULT_PATH)
  add_header_peer(meshlib "MeshLib::MRMesh;TBB::tbb")
  target_compile_features(bench_meshlib PRIVATE cxx_std_20)  # its headers need this
  target_compile_definitions(clearway_bench_support PRIVATE CLEARWAY_BENCH_WITH_MESHLIB)
endif()
pkg_check_modules(BULLET QUIET IMPORTED_TARGET bullet-float64)
if(BULLET_FOUND)
  add_header_peer(bullet PkgConfig::BULLET)
  target_compile_definitions(clearway_bench_support PRIVATE CLEARWAY_BENCH_WITH_BULLET)
else()
  message(STATUS "Benchmarks without Bullet: bullet-float64 is not installed (Debian: libbullet-dev)")
endif()
