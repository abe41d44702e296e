# cmake -D PROGRAM=geodesic_remesh -D FOLDER=folder -P generate_texts.cmake: what is installed beside the program, under the names
# that man and the shells look for
foreach(text man complete-bash complete-zsh)
  set(name_of_man geodesic_remesh.1)
  set(name_of_complete-bash geodesic_remesh)
  set(name_of_complete-zsh _geodesic_remesh)
  execute_process(COMMAND ${PROGRAM} --generate ${text} OUTPUT_FILE ${FOLDER}/${name_of_${text}} RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "${PROGRAM} --generate ${text} failed: ${failed}")
  endif()
endforeach()
