# Copies the libraries that the Python module needs beside it, but for those of the C and C++ run time: cmake -DFOLDER=... -DPATCHELF=... -P
# The copies have names of their own, so that a process that loads another build of such a library has both.

file(GLOB ours ${FOLDER}/*.so ${FOLDER}/libclearway*)
file(GET_RUNTIME_DEPENDENCIES RESOLVED_DEPENDENCIES_VAR found LIBRARIES ${ours}
     PRE_EXCLUDE_REGEXES "^ld-linux" "^lib(c|m|dl|rt|pthread|stdc[+][+]|gcc_s)[.]" POST_EXCLUDE_REGEXES "/libclearway")
set(copies "")
foreach(library IN LISTS found)
  get_filename_component(name ${library} NAME)
  string(REPLACE .so -clearway.so own ${name})
  list(APPEND renamed --replace-needed ${name} ${own})
  file(REAL_PATH ${library} real)
  file(COPY_FILE ${real} ${FOLDER}/${own})
  file(CHMOD ${FOLDER}/${own} PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
  execute_process(COMMAND ${PATCHELF} --set-soname ${own} ${FOLDER}/${own} COMMAND_ERROR_IS_FATAL ANY)
  list(APPEND copies ${FOLDER}/${own})
  list(APPEND CMAKE_INSTALL_MANIFEST_FILES ${FOLDER}/${own})  # scikit-build packs what is listed
endforeach()
foreach(file IN LISTS ours copies)  # in two steps: patchelf 0.14 mixes the two up
  execute_process(COMMAND ${PATCHELF} ${renamed} ${file} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${PATCHELF} --set-rpath $ORIGIN ${file} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
