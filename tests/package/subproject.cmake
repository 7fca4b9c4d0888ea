# -DSOURCE= pal's source tree, -DPAL= the program, -DWORK=, -DGENERATOR=, -DCOMPILER=, -DLAUNCHER= of the compiler
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE "${WORK}")
file(COPY "${SOURCE}/tests/package/outside/blink" DESTINATION "${WORK}")
# No CMAKE_CXX_STANDARD: pal::runtime asks for what it needs. careless.cpp has warnings: pal does not force its own
# flags on others, not even where it treats them as errors itself.
file(WRITE "${WORK}/blink/CMakeLists.txt" "
cmake_minimum_required(VERSION 3.25)
project(blink LANGUAGES CXX)
include(FetchContent)
FetchContent_Declare(pal SOURCE_DIR \"${SOURCE}\")
FetchContent_MakeAvailable(pal)
pal_add_skill(blink PAL blink.pal ENVIRONMENT bench.pal SOURCES blink.cpp careless.cpp)
add_executable(blink main.cpp)
target_link_libraries(blink PRIVATE pal::skill_blink)
")
file(WRITE "${WORK}/blink/careless.cpp" "int careless(double x, int y) { int x2 = (int)x; return x2; }\n")
run(${CMAKE_COMMAND} -G "${GENERATOR}" -S "${WORK}/blink" -B "${WORK}/build" "-DPAL_PROGRAM=${PAL}"
    -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=20
    "-DPAL_WARNINGS_AS_ERRORS=ON" "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}")
run(${CMAKE_COMMAND} --build "${WORK}/build")
run("${WORK}/build/blink")
if(EXISTS "${WORK}/build/bin")
  message(FATAL_ERROR "pal chose where another project's programs go")
endif()
