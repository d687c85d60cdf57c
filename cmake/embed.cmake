# Makes a C++ file of text files: cmake -DOUT=F.cpp "-DTEXTS=name=file;..." -P embed.cmake
# Defines each text as `extern const char NAME[]` in namespace clearway::report. CMake does this itself, so the build needs no
# other program.
cmake_minimum_required(VERSION 3.25)

file(WRITE ${OUT}.tmp "namespace clearway::report {\n\n")
foreach(pair IN LISTS TEXTS)
  string(REGEX MATCH "^([^=]+)=(.+)$" matched "${pair}")
  set(name ${CMAKE_MATCH_1})
  file(READ "${CMAKE_MATCH_2}" text)
  string(FIND "${text}" ")embedded\"" end)
  if(NOT end EQUAL -1)
    message(FATAL_ERROR "${pair} holds the end of a raw string, )embedded\", expected a text without it")
  endif()
  file(APPEND ${OUT}.tmp "extern const char ${name}[];\nconst char ${name}[] = R\"embedded(")
  file(APPEND ${OUT}.tmp "${text}")
  file(APPEND ${OUT}.tmp ")embedded\";\n\n")
endforeach()
file(APPEND ${OUT}.tmp "}  // namespace clearway::report\n")
file(RENAME ${OUT}.tmp ${OUT})
