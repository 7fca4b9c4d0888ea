# Installs pal into an empty folder, and builds and runs a project with it that knows nothing else.
# -DFROM= install (cmake --install) or packages (those that pack.cmake made), -DBUILD= the build tree, -DSKILL= the project, -DPROGRAM= what it
# builds, -DWORK= a folder to do it in, -DGENERATOR=, -DCOMPILER=, -DFLAGS=
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

if(FROM STREQUAL install)
  file(REMOVE_RECURSE "${WORK}")
  set(prefix "${WORK}/root")
  run(${CMAKE_COMMAND} --install "${BUILD}" --prefix "${prefix}" --component tools)
  run(${CMAKE_COMMAND} --install "${BUILD}" --prefix "${prefix}" --component development)
else()
  file(REMOVE_RECURSE "${WORK}/root" "${WORK}/build")
  file(GLOB packages "${WORK}/packages/*/*.deb")
  foreach(package IN LISTS packages)
    run(dpkg-deb --extract "${package}" "${WORK}/root")
    # What the headers of the workcell include comes with the package, also to a system that has nothing else.
    execute_process(COMMAND dpkg-deb --field "${package}" Depends OUTPUT_VARIABLE needed)
    if(package MATCHES "pal-development" AND EXISTS "${WORK}/root/usr/include/pal-workcell" AND NOT needed MATCHES "libeigen3-dev")
      message(FATAL_ERROR "pal-development needs libeigen3-dev and does not say so: ${needed}")
    endif()
  endforeach()
  set(prefix "${WORK}/root/usr")
endif()

# The shells find what they complete.
foreach(completion bash-completion/completions/pal zsh/vendor-completions/_pal fish/vendor_completions.d/pal.fish)
  file(STRINGS "${prefix}/share/${completion}" found REGEX "whatif")
  if(NOT found)
    message(FATAL_ERROR "${completion} does not complete the commands of pal")
  endif()
endforeach()

# What is installed is public: each header stands alone, below pal/ or, for the workcell, pal-workcell/, and no other is there.
file(GLOB_RECURSE headers RELATIVE "${prefix}/include" "${prefix}/include/*")
set(all "")
foreach(header IN LISTS headers)
  if(NOT header MATCHES "^pal/(runtime|trace)/[a-z_]+\\.hpp$|^pal-workcell/(runtime/drivers|skills_pal/(modules|sensing))/[a-z_/]+\\.hpp$"
     OR header MATCHES "/(run|mail|scheduler|event_queue|bridge|pseudo_terminal)\\.hpp$")
    message(FATAL_ERROR "${header} is installed")
  endif()
  string(REPLACE "pal-workcell/" "" header "${header}")
  string(APPEND all "#include <${header}>\n")
endforeach()
file(WRITE "${WORK}/all_headers.cpp" "${all}")
run("${COMPILER}" -std=c++20 -fsyntax-only -Wall -Wextra -Werror "-I${prefix}/include" "-I${prefix}/include/pal-workcell"
    -isystem /usr/include/eigen3 "${WORK}/all_headers.cpp")

run(${CMAKE_COMMAND} -G "${GENERATOR}" -S "${SKILL}" -B "${WORK}/build" "-DCMAKE_PREFIX_PATH=${prefix}"
    "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror ${FLAGS}")
run(${CMAKE_COMMAND} --build "${WORK}/build")
run("${WORK}/build/${PROGRAM}")

# The files of a skill are found again: a second build has nothing to generate.
run(${CMAKE_COMMAND} --build "${WORK}/build")
if(output MATCHES "Checking skill")
  message(FATAL_ERROR "what was built is built again:\n${output}")
endif()
