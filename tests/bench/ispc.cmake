# The kernels of `benchmarks kernels` that are written in ISPC, if there is an ispc: with -DCLEARWAY_ISPC=/path/to/ispc, or in the path.
find_program(CLEARWAY_ISPC ispc DOC "The compiler of ISPC for `benchmarks kernels`; none is fine")

# add_ispc_kernels(TARGET SOURCE...): compiles each source for each instruction set. ispc names the objects and functions of a
# set by its own suffix.
function(add_ispc_kernels target)
  if(NOT CLEARWAY_ISPC OR NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    return()
  endif()
  foreach(source IN LISTS ARGN)
    cmake_path(GET source STEM name)
    set(object ${CMAKE_CURRENT_BINARY_DIR}/ispc/${name})
    set(objects ${object}_sse4.o ${object}_avx2.o ${object}_avx512skx.o)
    add_custom_command(OUTPUT ${objects}
                       COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_CURRENT_BINARY_DIR}/ispc
                       COMMAND ${CLEARWAY_ISPC} --pic -O3 --target=sse4-i32x4,avx2-i32x8,avx512skx-x16
                               ${CMAKE_CURRENT_SOURCE_DIR}/${source} -o ${object}.o
                       DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${source} ${CMAKE_CURRENT_SOURCE_DIR}/bench/ispc/points.isph
                       VERBATIM)
    target_sources(${target} PRIVATE ${objects})
  endforeach()
  target_compile_definitions(${target} PRIVATE CLEARWAY_BENCH_WITH_ISPC)
endfunction()
