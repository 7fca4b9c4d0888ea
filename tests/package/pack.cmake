# Makes the Debian package of one part of pal: -DBUILD= the build tree, -DPART= the part, -DINTO= an empty folder for it.
file(REMOVE_RECURSE "${INTO}")
execute_process(COMMAND ${CMAKE_CPACK_COMMAND} -G DEB --config "${BUILD}/CPackConfig.cmake" -B "${INTO}"
                        -D CPACK_COMPONENTS_ALL=${PART}
                RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
file(GLOB packages "${INTO}/*.deb")
list(LENGTH packages count)
if(NOT status EQUAL 0 OR NOT count EQUAL 1)
  message(FATAL_ERROR "cpack ended with ${status} and made ${count} packages, not 1: ${packages}\n${output}")
endif()
