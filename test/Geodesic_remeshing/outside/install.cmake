# cmake -D BUILD=build_folder -D SOURCE=source_folder -D PREFIX=prefix -P install.cmake
# Installs, and compares: every header is there, and nothing that is none of the package.
file(REMOVE_RECURSE ${PREFIX})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

file(GLOB_RECURSE wanted RELATIVE ${SOURCE} ${SOURCE}/include/*.h)
file(GLOB_RECURSE found RELATIVE ${PREFIX} ${PREFIX}/include/*)
if(NOT wanted STREQUAL found)
  message(FATAL_ERROR "the headers of the package are\n${wanted}\nand those installed\n${found}")
endif()
foreach(file Geodesic_remeshingConfig.cmake Geodesic_remeshingConfigVersion.cmake Geodesic_remeshing_targets.cmake)
  file(GLOB_RECURSE there ${PREFIX}/*/${file})
  if(NOT there)
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()
