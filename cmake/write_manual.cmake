# Writes the program's man pages and its completion script: cmake -DPROGRAM=clearway -DOUT=FOLDER -P write_manual.cmake
# The program prints them itself, one page for each subcommand that its own page names.
cmake_minimum_required(VERSION 3.25)

function(write file)
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_FILE ${file} RESULT_VARIABLE result)
  if(result)
    message(FATAL_ERROR "${PROGRAM} ${ARGN} ended with ${result}, expected 0")
  endif()
endfunction()

file(REMOVE_RECURSE ${OUT}/man1)
file(MAKE_DIRECTORY ${OUT}/man1)
write(${OUT}/man1/clearway.1 --man)
write(${OUT}/completion --completion)
execute_process(COMMAND ${PROGRAM} --help OUTPUT_VARIABLE help)
string(REGEX MATCHALL "\n  [a-z]+  +" rows "${help}")
foreach(row IN LISTS rows)
  string(STRIP "${row}" subcommand)
  write(${OUT}/man1/clearway-${subcommand}.1 ${subcommand} --man)
endforeach()
file(TOUCH ${OUT}/done)
