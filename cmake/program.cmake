# The program clearway, and the libraries that only it and the demos need. They reuse the precompiled headers of clearway_planning, which
# take seconds to make.

# Pictures.
set(font_bytes ${PROJECT_BINARY_DIR}/generated/font_bytes.cpp)
add_custom_command(OUTPUT ${font_bytes} VERBATIM
                   COMMAND ${CMAKE_COMMAND} -DOUT=${font_bytes} -DFONT=${CLEARWAY_FONT}
                           -P ${PROJECT_SOURCE_DIR}/cmake/embed_font.cmake
                   DEPENDS ${CLEARWAY_FONT} ${PROJECT_SOURCE_DIR}/cmake/embed_font.cmake)
file(GLOB render_sources CONFIGURE_DEPENDS src/program/render/*.cpp)
add_library(clearway_font OBJECT ${font_bytes})  # apart, because CMake makes a target's generated files wait for what it links
add_library(clearway_render STATIC ${render_sources} $<TARGET_OBJECTS:clearway_font>)
target_include_directories(clearway_render PRIVATE src)
target_link_libraries(clearway_render PUBLIC clearway PRIVATE clearway_warnings embree PkgConfig::CAIRO PNG::PNG TBB::tbb)
target_compile_definitions(clearway_render PRIVATE CLEARWAY_EMBREE_MAJOR=${EMBREE_VERSION_MAJOR})
target_precompile_headers(clearway_render REUSE_FROM clearway_planning)
compile_together(clearway_render render ${render_sources})

# Messages between ranks under mpirun. This one file sees MPI, where there is MPI.
add_library(clearway_ranks STATIC src/program/bench/ranks.cpp)
target_include_directories(clearway_ranks PRIVATE src)
target_compile_features(clearway_ranks PUBLIC cxx_std_17)
target_link_libraries(clearway_ranks PRIVATE clearway_warnings)
if(MPI_CXX_FOUND)
  target_link_libraries(clearway_ranks PRIVATE MPI::MPI_CXX)
  target_compile_definitions(clearway_ranks PRIVATE CLEARWAY_WITH_MPI)
endif()

# Texts of the report page. They become part of the program, so that a page needs no other file and no network.
set(page_texts ${PROJECT_BINARY_DIR}/generated/page_texts.cpp)
set(page_folder ${PROJECT_SOURCE_DIR}/src/program/report)
set(page_files page/page.html page/page.css page/shared.js page/meshes.js page/layers.js page/eye.js page/view.js page/profile.js
               page/panels.js page/main.js vendor/three/three.module.min.js vendor/three/OrbitControls.js)
list(TRANSFORM page_files PREPEND ${page_folder}/)
set(page_names kPageHtml kPageStyle kPageShared kPageMeshes kPageLayers kPageEye kPageView kPageProfile kPagePanels kPageMain
               kThreeModule kOrbitControls)
set(page_pairs "")
foreach(name file IN ZIP_LISTS page_names page_files)
  list(APPEND page_pairs "${name}=${file}")
endforeach()
add_custom_command(OUTPUT ${page_texts} VERBATIM
                   COMMAND ${CMAKE_COMMAND} -DOUT=${page_texts} "-DTEXTS=${page_pairs}"
                           -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
                   DEPENDS ${page_files} ${PROJECT_SOURCE_DIR}/cmake/embed.cmake)

# -O3 would take half as long again to compile for code that reads options and prints tables.
set(moderately $<$<CONFIG:Release>:-O2>)

# The command line and the subcommands of clearway, which the demos' programs and tests link, too.
file(GLOB cli_sources CONFIGURE_DEPENDS src/program/report/*.cpp src/program/options/*.cpp src/program/bench/*.cpp src/program/cli/*.cpp)
list(FILTER cli_sources EXCLUDE REGEX "/(cli/main|bench/ranks)\\.cpp$")
add_library(clearway_page_texts OBJECT ${page_texts})
add_library(clearway_cli STATIC ${cli_sources} $<TARGET_OBJECTS:clearway_page_texts>)
target_include_directories(clearway_cli PRIVATE src)
target_link_libraries(clearway_cli PUBLIC clearway clearway_planning clearway_render
                      PRIVATE clearway_ranks clearway_warnings Boost::headers nlohmann_json::nlohmann_json TBB::tbb)
target_precompile_headers(clearway_cli REUSE_FROM clearway_planning)
target_compile_options(clearway_cli PRIVATE ${moderately})
compile_together(clearway_cli program ${cli_sources})

# add_tool(TARGET NAME "LIBRARY..." SOURCE...): a program that is built as NAME.
function(add_tool target name libraries)
  add_executable(${target} ${ARGN})
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${target} PRIVATE ${libraries} clearway_warnings nlohmann_json::nlohmann_json TBB::tbb)
  target_precompile_headers(${target} REUSE_FROM clearway_planning)
  target_compile_options(${target} PRIVATE ${moderately})
endfunction()
add_tool(clearway_program clearway clearway_cli src/program/cli/main.cpp)
