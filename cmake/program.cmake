# The program clearway, and the libraries that only it and the demos need.

# Pictures.
file(GLOB render_sources CONFIGURE_DEPENDS src/program/render/*.cpp)
add_library(clearway_render STATIC ${render_sources})
target_include_directories(clearway_render PRIVATE src)
target_link_libraries(clearway_render PUBLIC clearway PRIVATE clearway_warnings embree fmt::fmt-header-only PkgConfig::CAIRO PNG::PNG TBB::tbb)
target_compile_definitions(clearway_render PRIVATE CLEARWAY_EMBREE_MAJOR=${EMBREE_VERSION_MAJOR} CLEARWAY_FONT="${CLEARWAY_FONT}")
set_source_files_properties(src/program/render/ink_mask.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON OBJECT_DEPENDS "${CLEARWAY_FONT}")

# The command line, and what is printed: without OMPL, for clearway-cad.
file(GLOB options_sources CONFIGURE_DEPENDS src/program/options/*.cpp)
set(line_sources ${options_sources})
list(FILTER line_sources INCLUDE REGEX "/(command_line|help|load_guard|print)\\.cpp$")
list(REMOVE_ITEM options_sources ${line_sources})
add_library(clearway_line STATIC ${line_sources})
target_include_directories(clearway_line PRIVATE src)
target_include_directories(clearway_line SYSTEM PRIVATE $<TARGET_PROPERTY:clearway::ompl,INTERFACE_INCLUDE_DIRECTORIES>)  # their versions
target_link_libraries(clearway_line PUBLIC clearway PRIVATE clearway_warnings Boost::headers assimp::assimp embree fmt::fmt-header-only)

# The command line and the subcommands of clearway, which the demos' programs and tests link, too.
file(GLOB cli_sources CONFIGURE_DEPENDS src/program/report/*.cpp src/program/bench/*.cpp src/program/cli/*.cpp)
list(FILTER cli_sources EXCLUDE REGEX "/cli/main\\.cpp$")
add_library(clearway_cli STATIC ${options_sources} ${cli_sources})
set(report ${PROJECT_SOURCE_DIR}/src/program/report)  # a page needs no other file and no network: the program holds its texts
file(GLOB page_files CONFIGURE_DEPENDS ${report}/page/* ${report}/vendor/three/*.js)
set_source_files_properties(src/program/report/report.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON OBJECT_DEPENDS "${page_files}")
target_compile_definitions(clearway_cli PRIVATE CLEARWAY_REPORT="${report}")
target_include_directories(clearway_cli PRIVATE src)
target_link_libraries(clearway_cli PUBLIC clearway_line clearway clearway_planning clearway_render
                      PRIVATE clearway_warnings Boost::headers fmt::fmt-header-only nlohmann_json::nlohmann_json TBB::tbb)
if(MPI_CXX_FOUND)  # messages between ranks under mpirun; bench/ranks.cpp alone sees MPI
  target_link_libraries(clearway_cli PRIVATE MPI::MPI_CXX)
  target_compile_definitions(clearway_cli PRIVATE CLEARWAY_WITH_MPI)
endif()

# add_tool(TARGET NAME "LIBRARY..." SOURCE...): a program that is built as NAME.
function(add_tool target name libraries)
  add_executable(${target} ${ARGN})
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${target} PRIVATE ${libraries} clearway_warnings fmt::fmt-header-only nlohmann_json::nlohmann_json TBB::tbb)
endfunction()
add_tool(clearway_program clearway clearway_cli src/program/cli/main.cpp)

# clearway-cad, which alone links OpenCASCADE: 7.8 puts the readers of a format into a library of its own, TKDESTEP and TKDEIGES.
if(OpenCASCADE_FOUND)
  add_library(clearway_cad STATIC src/cad/cad_file.cpp src/cad/tessellate.cpp)
  target_include_directories(clearway_cad PRIVATE src)
  target_include_directories(clearway_cad SYSTEM PUBLIC ${OpenCASCADE_INCLUDE_DIR})
  target_link_libraries(clearway_cad PUBLIC clearway ${cad_libraries} PRIVATE clearway_warnings Boost::headers fmt::fmt-header-only)
  add_tool(clearway_cad_program clearway-cad "clearway_cad;clearway_line;Boost::headers" src/cad/main.cpp)
endif()
