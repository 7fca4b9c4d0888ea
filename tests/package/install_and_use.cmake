# -DBUILD= the build tree, -DSKILL= the project that uses it, -DPROGRAM= what it builds, -DWORK= a folder to do it in, -DGENERATOR=, -DCOMPILER=, -DFLAGS=
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE "${WORK}")
run(${CMAKE_COMMAND} --install "${BUILD}" --prefix "${WORK}/installed" --component development)
run(${CMAKE_COMMAND} -G "${GENERATOR}" -S "${SKILL}" -B "${WORK}/build" "-DCMAKE_PREFIX_PATH=${WORK}/installed"
    "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror ${FLAGS}")
run(${CMAKE_COMMAND} --build "${WORK}/build")
run("${WORK}/build/${PROGRAM}")
