# CPack runs this script before it packs the staged files: adds what Debian's policy asks of each package, the copyright and the
# changelogs, and compresses the man pages.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(READ ${CPACK_CLEARWAY_SOURCE}/LICENSE licence)
foreach(package IN LISTS CPACK_COMPONENTS_ALL)
  set(stage ${CPACK_TEMPORARY_DIRECTORY}/${package})
  file(REMOVE_RECURSE ${stage}/usr/share/doc)
  set(folder ${stage}/usr/share/doc/${package})
  file(MAKE_DIRECTORY ${folder})
  set(copyright "${licence}")
  if(package STREQUAL clearway-tools)  # the program holds three.js and a font
    file(READ ${CPACK_CLEARWAY_SOURCE}/src/program/report/vendor/three/LICENSE three)
    file(READ ${CPACK_CLEARWAY_FONT_COPYRIGHT} font)
    string(APPEND copyright "\nReport pages hold three.js:\n\n${three}\nPictures hold letters of DejaVu Sans:\n\n${font}")
  endif()
  file(WRITE ${folder}/copyright "${copyright}")
  configure_file(${CPACK_CLEARWAY_SOURCE}/CHANGELOG.md ${folder}/changelog COPYONLY)
  configure_file(${CPACK_CLEARWAY_CHANGELOG} ${folder}/changelog.Debian COPYONLY)
  file(GLOB pages ${stage}/usr/share/man/man1/*)
  run(gzip -9n ${folder}/changelog ${folder}/changelog.Debian ${pages})
  run(chmod -R u=rwX,go=rX ${stage}/usr/share/doc)
endforeach()
