# `cmake --build BUILD --target reference` makes the HTML reference: BUILD/reference/index.html.

find_program(CLEARWAY_DOXYGEN doxygen)
find_program(CLEARWAY_PYTHON_PROGRAM python3)
if(CLEARWAY_DOXYGEN AND CLEARWAY_PYTHON_PROGRAM)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/reference/Doxyfile.in generated/Doxyfile @ONLY)
  add_custom_target(reference COMMAND ${CLEARWAY_DOXYGEN} ${PROJECT_BINARY_DIR}/generated/Doxyfile VERBATIM)
else()
  add_custom_target(reference COMMAND ${CMAKE_COMMAND} -E echo "The reference needs the programs doxygen and python3"
                              COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
endif()
