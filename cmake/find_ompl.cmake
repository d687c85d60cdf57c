# Finds OMPL as the target clearway::ompl, or says in clearway_ompl_fault why it cannot. The build and the installed
# clearwayConfig.cmake read this file. OMPL exports a target or variables, depending on its version; its headers count as system
# headers, so that the compiler does not warn about them.

set(clearway_ompl_fault "")
find_package(ompl QUIET CONFIG)  # without a version, because OMPL's version file says that 2.0 does not satisfy 1.5
find_package(Threads QUIET)
set(clearway_ompl_FOUND FALSE)
if(ompl_FOUND)
  set(clearway_ompl_FOUND TRUE)
endif()
if(ompl_FOUND AND ompl_VERSION VERSION_LESS 1.5)
  set(clearway_ompl_FOUND FALSE)
  set(clearway_ompl_fault "the one in ${ompl_DIR} is ${ompl_VERSION}; ")
endif()
if(clearway_ompl_FOUND AND NOT TARGET clearway::ompl)
  add_library(clearway::ompl INTERFACE IMPORTED GLOBAL)
  if(TARGET ompl::ompl)
    target_link_libraries(clearway::ompl INTERFACE ompl::ompl Threads::Threads)
  else()
    # Debian 13's omplConfig lists folders of HDF5 and MPI, which its package does not require. CMake refuses folders that are missing.
    foreach(clearway_ompl_folder IN LISTS OMPL_INCLUDE_DIRS)
      if(IS_DIRECTORY "${clearway_ompl_folder}")
        target_include_directories(clearway::ompl SYSTEM INTERFACE ${clearway_ompl_folder})
      endif()
    endforeach()
    # omplConfig also lists ODE and serialization libraries, which only OMPL.app's programs need.
    list(FILTER OMPL_LIBRARIES INCLUDE REGEX "libompl")
    target_link_libraries(clearway::ompl INTERFACE ${OMPL_LIBRARIES} Threads::Threads)
  endif()
endif()
