# The programs clearway, clearway-scene and clearway-study, and the libraries that only they need. They reuse the precompiled headers of
# clearway_planning, which take seconds to make.

# The demo scenes. The program clearway links none of them.
file(GLOB scenes_sources CONFIGURE_DEPENDS src/program/scenes/*.cpp)
add_library(clearway_scenes STATIC ${scenes_sources})
target_include_directories(clearway_scenes PRIVATE src)
target_link_libraries(clearway_scenes PUBLIC clearway PRIVATE clearway_warnings)
target_precompile_headers(clearway_scenes REUSE_FROM clearway_planning)
compile_together(clearway_scenes scenes ${scenes_sources})

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
add_library(clearway_ranks STATIC src/program/study/ranks.cpp)
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

# The command line and the subcommands of clearway, which all three programs and tests link.
file(GLOB study_sources CONFIGURE_DEPENDS src/program/study/*.cpp)
file(GLOB cli_sources CONFIGURE_DEPENDS src/program/report/*.cpp src/program/cli/*.cpp src/program/study/*.cpp)
# Files of the study that `clearway bench` needs.
set(of_bench "/study/(benchmark|benchmark_log|child_process|hand_out|kept_runs|planner_run|run_text|settings|table)\\.cpp$")
list(FILTER study_sources EXCLUDE REGEX "${of_bench}|/study/ranks\\.cpp$")
list(FILTER cli_sources EXCLUDE REGEX "/(cli/main|study/ranks)\\.cpp$")
list(REMOVE_ITEM cli_sources ${study_sources})
add_library(clearway_page_texts OBJECT ${page_texts})
add_library(clearway_cli STATIC ${cli_sources} $<TARGET_OBJECTS:clearway_page_texts>)
target_include_directories(clearway_cli PRIVATE src)
target_link_libraries(clearway_cli PUBLIC clearway clearway_planning clearway_render
                      PRIVATE clearway_ranks clearway_warnings Boost::headers nlohmann_json::nlohmann_json TBB::tbb)
target_precompile_headers(clearway_cli REUSE_FROM clearway_planning)
target_compile_options(clearway_cli PRIVATE ${moderately})
compile_together(clearway_cli program ${cli_sources})

# The study of leaf splits.
add_library(clearway_study STATIC ${study_sources})
target_include_directories(clearway_study PRIVATE src)
target_link_libraries(clearway_study PUBLIC clearway_cli PRIVATE clearway_warnings nlohmann_json::nlohmann_json)
target_precompile_headers(clearway_study REUSE_FROM clearway_planning)
target_compile_options(clearway_study PRIVATE ${moderately})
compile_together(clearway_study study ${study_sources})

# add_tool(TARGET NAME "LIBRARY..." SOURCE...): a program that is built as NAME.
function(add_tool target name libraries)
  add_executable(${target} ${ARGN})
  set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name})
  target_include_directories(${target} PRIVATE src)
  target_link_libraries(${target} PRIVATE ${libraries} clearway_warnings nlohmann_json::nlohmann_json TBB::tbb)
  target_precompile_headers(${target} REUSE_FROM clearway_planning)
  target_compile_options(${target} PRIVATE ${moderately})
endfunction()
set(folder src/program)
add_tool(clearway_program clearway clearway_cli ${folder}/cli/main.cpp)
add_tool(clearway_scene_program clearway-scene "clearway_cli;clearway_scenes"
         ${folder}/clearway_scene/main.cpp ${folder}/clearway_scene/record_scene.cpp)
add_tool(clearway_study_program clearway-study "clearway_study;clearway_scenes"
         ${folder}/clearway_study/main.cpp ${folder}/clearway_study/print_study.cpp ${folder}/clearway_scene/record_scene.cpp)
