# The files of data that no generator makes again keep their bytes. Run as
# `cmake -DROOT=<repository> -P data_checksums.cmake`.
cmake_minimum_required(VERSION 3.25)

# require_files(FOLDER NAME SHA-256 ...): the folder of data holds these files and no others.
function(require_files name)
  set(folder ${ROOT}/data/${name})
  set(expected ${ARGN})
  file(GLOB found RELATIVE ${folder} ${folder}/*)
  list(LENGTH found count)
  list(LENGTH expected twice)
  math(EXPR wanted "${twice} / 2")
  if(NOT count EQUAL wanted)
    message(FATAL_ERROR "${folder} holds ${count} files, expected ${wanted}")
  endif()
  while(expected)
    list(POP_FRONT expected file sum)
    file(SHA256 ${folder}/${file} actual)
    if(NOT actual STREQUAL sum)
      message(FATAL_ERROR "${folder}/${file} has the SHA-256 ${actual}, expected ${sum}")
    endif()
  endwhile()
endfunction()

require_files(tunnel-console-small
    tunnel-console.cfg 8df8c1030b6cf126d6c36450f4348660e4d33aa9e12ad735fafe8c99cfaf4cd4
    tunnel-console.path a1543e3cc83a07ef360da17a3b85bb1fbb72132efee401bf0255910dbc059d10
    tunnel-console.png 99100d69ac4480fedf23683b217017a83b7769ad3fa332d26046f2d202750381
    tunnel-console_environment.obj 6b590d47a758b5e1f7c1db89bb7bc08d868ae93cc183210b18c629a6e757edaf
    tunnel-console_part.obj 3aea9b34de9b9c602f9f3007b7fbf4c2960eca43849750dd8c8af99862cdba87
    tunnel-console_replay.poses 8e59c7383a1b3710ee2f84c1bb7b6da64d393b4bc09fd21569387dedb8f84291)
require_files(angle
    angle.cfg 557adffbc017ad82a83330e77823a7e5e77c89d8470f53dfc6b69ba2a6aacee9
    angle.obj 411e6aa2d09ebee0ad04a56bc5a2791338ff80c9d27a5671cc8c5b6598a5b27a
    housing.obj 66485d9eeaa98afd6fe9e332610ea9b3fcf0c947b8b82199a458150d2ef155d8)
require_files(bracket
    bracket.cfg 8c126d89d4fc122bcfd3500cff915a606cab3aa8aeac0bc4e9e67da2a4690ee9
    bracket.stl 7a815f72aa7f5946a7eeb00abca46afff79c75841d225beb750a5fa686de0b7b
    housing.stl 8706f14ed77aabe085eab611d903456d15abc985a9c7359021763731104b33b9
    wall.stl a99fefb1b052f4ae0a0d4da0eb40b467907d2abc6376a7b0122960b4d06474cb)
