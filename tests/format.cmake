# Every source file is laid out as .clang-format says, judged by the clang-format of Debian 12: others lay out some lines differently. Run as
# `cmake -DROOT=<repository> -DCLANG_FORMAT=<program> -P format.cmake`.
cmake_minimum_required(VERSION 3.25)

file(GLOB_RECURSE files "${ROOT}/src/*.h" "${ROOT}/src/*.cpp" "${ROOT}/include/*.h" "${ROOT}/demos/*.h" "${ROOT}/demos/*.cpp"
     "${ROOT}/demos/*.c" "${ROOT}/tests/*.h" "${ROOT}/tests/*.cpp" "${ROOT}/tests/*.c")
list(LENGTH files count)
if(count EQUAL 0)
  message(FATAL_ERROR "ROOT is '${ROOT}', expected a folder with source files under src, include, demos or tests")
endif()
execute_process(COMMAND "${CLANG_FORMAT}" --version OUTPUT_VARIABLE version)
if(NOT version MATCHES "version 14\\.")
  message(STATUS "skipped: format is judged by clang-format 14 alone, this one is ${version}")
  return()
endif()
execute_process(COMMAND "${CLANG_FORMAT}" --dry-run -Werror ${files} RESULT_VARIABLE result ERROR_VARIABLE errors)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "clang-format would change these files:\n${errors}")
endif()
message(STATUS "format: ${count} files are laid out as .clang-format says")
