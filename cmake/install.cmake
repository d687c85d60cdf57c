# The install target installs the libraries, the headers, the program and its manual, and the files through which find_package and pkg-config find it.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
foreach(folder CMAKE_INSTALL_LIBDIR CMAKE_INSTALL_INCLUDEDIR)
  if(IS_ABSOLUTE "${${folder}}")
    message(FATAL_ERROR "${folder} is ${${folder}}, expected a folder below the prefix: what is installed finds its other files by relative paths")
  endif()
endforeach()
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/clearway)
set(generated ${PROJECT_BINARY_DIR}/generated)

# install_library(TARGET NAME KIND PACKAGE): installs a library in an export set of its own. A static library and its shared twin,
# if there is one, bear one name: clearwayConfig.cmake chooses between them. PACKAGE is the component of what programs need.
function(install_library target name kind package)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS ${target} EXPORT ${name}_${kind}
          LIBRARY COMPONENT ${package} NAMELINK_COMPONENT libclearway-dev
          ARCHIVE COMPONENT libclearway-dev
          INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT ${name}_${kind} NAMESPACE clearway:: DESTINATION ${config_dir} COMPONENT libclearway-dev)
endfunction()
install_library(clearway clearway static libclearway)
if(BUILD_SHARED_LIBS)
  install_library(clearway_shared clearway shared libclearway)
endif()
if(CLEARWAY_PLANNING)
  install_library(clearway_planning planning static libclearway-planning)
  if(BUILD_SHARED_LIBS)
    install_library(clearway_planning_shared planning shared libclearway-planning)
    set_target_properties(clearway_planning_shared PROPERTIES INSTALL_RPATH $ORIGIN)  # libclearway lies beside it
  endif()
endif()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT libclearway)

# Headers.
set(without_planning "")
if(NOT CLEARWAY_PLANNING)
  set(without_planning PATTERN planning EXCLUDE)
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/clearway DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT libclearway-dev
        FILES_MATCHING PATTERN *.h ${without_planning})
install(FILES ${generated}/include/clearway/version.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/clearway COMPONENT libclearway-dev)

# find_package(clearway).
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/clearwayConfig.cmake.in ${generated}/clearwayConfig.cmake
                              INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${generated}/clearwayConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${generated}/clearwayConfig.cmake ${generated}/clearwayConfigVersion.cmake ${CMAKE_CURRENT_LIST_DIR}/find_ompl.cmake
        DESTINATION ${config_dir} COMPONENT libclearway-dev)

# pkg-config. Who links the static libraries also links what these need: everybody where there are no others. Where there are, these
# are named as libraries: pkg-config refuses a package whose Requires.private is not installed even to users of the shared libraries.
set(pc_libraries -lclearway)
set(pc_libraries_privately -lassimp -lhwy -lpugixml -ltbb -lzip)
if(CLEARWAY_EMBREE)
  list(APPEND pc_libraries_privately -lembree${EMBREE_VERSION_MAJOR})
endif()
foreach(library IN LISTS CMAKE_CXX_IMPLICIT_LINK_LIBRARIES)
  if(library MATCHES "^(stdc[+][+]|c[+][+]|m)$")  # for programs in C
    list(APPEND pc_libraries_privately -l${library})
  endif()
endforeach()
if(NOT BUILD_SHARED_LIBS)
  list(APPEND pc_libraries ${pc_libraries_privately})
endif()
foreach(list pc_libraries pc_libraries_privately)
  list(JOIN ${list} " " ${list})
endforeach()
file(RELATIVE_PATH pc_prefix /x/${CMAKE_INSTALL_LIBDIR}/pkgconfig /x)  # from where the files are, so that the tree can be moved
set(pc_files clearway)
if(CLEARWAY_PLANNING)
  list(APPEND pc_files clearway-planning)
  # OMPL's own ompl.pc is not asked: in Debian 12 it names libraries of Boost that its package does not require.
  find_path(pc_ompl_headers ompl/config.h HINTS ${OMPL_INCLUDE_DIRS} NO_CACHE REQUIRED)
  find_library(pc_ompl_library ompl HINTS ${OMPL_LIBRARY_DIRS} NO_CACHE REQUIRED)
  get_filename_component(pc_ompl_libraries ${pc_ompl_library} DIRECTORY)
endif()
foreach(name IN LISTS pc_files)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/${name}.pc.in ${generated}/${name}.pc @ONLY)
  install(FILES ${generated}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT libclearway-dev)
endforeach()

# The programs, with the man pages and the completion script that they print.
if(CLEARWAY_PROGRAM)
  set(programs clearway_program)
  set(names clearway)
  if(CLEARWAY_DEMOS)
    list(APPEND programs clearway_scene_program)
    list(APPEND names clearway-scene)
  endif()
  install(TARGETS ${programs} COMPONENT clearway-tools)
  if(TARGET clearway_cad_program)
    install(TARGETS clearway_cad_program COMPONENT clearway-cad)
    install(FILES ${PROJECT_BINARY_DIR}/manual/man1/clearway-cad.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT clearway-cad)
    list(APPEND programs clearway_cad_program)
    list(APPEND names clearway-cad)
  endif()
  set(manual ${PROJECT_BINARY_DIR}/manual)
  add_custom_command(OUTPUT ${manual}/done VERBATIM
                     COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:clearway_program> "-DNAMES=${names}" -DOUT=${manual}
                             -P ${CMAKE_CURRENT_LIST_DIR}/write_manual.cmake
                     DEPENDS ${programs} ${CMAKE_CURRENT_LIST_DIR}/write_manual.cmake)
  add_custom_target(clearway_manual ALL DEPENDS ${manual}/done)
  install(DIRECTORY ${manual}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT clearway-tools PATTERN clearway-cad.1 EXCLUDE)
  foreach(name IN LISTS names)  # bash looks for a file of the program's name
    set(component clearway-tools)
    if(name STREQUAL "clearway-cad")
      set(component clearway-cad)
    endif()
    install(FILES ${manual}/completion RENAME ${name} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
            COMPONENT ${component})
  endforeach()
endif()
