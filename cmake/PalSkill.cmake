# pal_add_skill(NAME PAL FILE ENVIRONMENT FILE SOURCES FILE… [SKILL NAME-IN-PAL] [ALLOW_FAILING] [WITHOUT_TIMES] [DEBUG_LINES]
#               [WORKCELL] [DECLARED FILE] [INSTALLED])
#
# A static library pal_skill_NAME (alias pal::skill_NAME) of a skill: its C++, generated from PAL, and SOURCES, the
# activities written by hand. They include "<skill>_activities.hpp" and "<skill>_skill.hpp", and devices "<skill>_devices.hpp", where <skill> is the skill's name in
# PAL with underscores for hyphens. SKILL is needed only if that name is not NAME.
#
# The skill is checked first: if it is wrong, or a requirement does not hold, the build fails with the analyzer's message.
# ALLOW_FAILING lets requirements fail; the message is shown all the same. WITHOUT_TIMES is for a skill that requires no
# time. DEBUG_LINES makes debuggers show lines of PAL. For gdb there
# is "<skill>.gdb" beside the generated code, with DEBUG_LINES or without.
#
# WORKCELL: also a file NAME.so (target pal_plugin_NAME), which workcell loads. SOURCES then have the function that gives the skill
# its activities: std::unique_ptr<pal::runtime::Skill> pal::skills::<skill>_skill().
# DECLARED: what the skill declares to the workcell, its longest times and its limits in charts (docs/workcell/declared.md).
# The file names the top of the source tree, so that workcell tells when that has changed since; INSTALLED: it does not.
function(pal_add_skill name)
  cmake_parse_arguments(ARG "ALLOW_FAILING;WITHOUT_TIMES;DEBUG_LINES;WORKCELL;INSTALLED" "PAL;ENVIRONMENT;SKILL;DECLARED" "SOURCES" ${ARGN})
  if(ARG_UNPARSED_ARGUMENTS OR NOT ARG_PAL OR NOT ARG_ENVIRONMENT)
    message(FATAL_ERROR "pal_add_skill(${name}): needs PAL and ENVIRONMENT, takes SOURCES, SKILL, ALLOW_FAILING, WITHOUT_TIMES, DEBUG_LINES, WORKCELL, DECLARED, INSTALLED")
  endif()
  if(ARG_DECLARED AND NOT ARG_WORKCELL)
    message(FATAL_ERROR "pal_add_skill(${name}): DECLARED is for a workcell: add WORKCELL")
  endif()
  if(NOT ARG_SKILL)
    set(ARG_SKILL ${name})
  endif()
  string(MAKE_C_IDENTIFIER "${ARG_SKILL}" prefix)
  string(TOLOWER "${prefix}" prefix)
  get_filename_component(pal_file "${ARG_PAL}" ABSOLUTE)
  get_filename_component(environment_file "${ARG_ENVIRONMENT}" ABSOLUTE)

  # Names of files in messages, traces and generated code are relative to the top of the source tree: the same everywhere.
  file(RELATIVE_PATH pal_name "${CMAKE_SOURCE_DIR}" "${pal_file}")
  file(RELATIVE_PATH environment_name "${CMAKE_SOURCE_DIR}" "${environment_file}")

  set(directory "${CMAKE_CURRENT_BINARY_DIR}/${name}_generated")  # one skill may be there for several environments
  file(MAKE_DIRECTORY "${directory}")
  set(generated)
  foreach(suffix messages.hpp parameters.hpp parameters.cpp activities.hpp devices.hpp wiring.hpp wiring.cpp modules.hpp modules.cpp
          skill.hpp skill.cpp)
    list(APPEND generated "${directory}/${prefix}_${suffix}")
  endforeach()

  # Where gdb finds what lines are of, and how it goes from statement to statement.
  get_filename_component(pal_folder "${pal_file}" DIRECTORY)
  file(WRITE "${directory}/${prefix}.gdb" 
    "directory \"${directory}\"\ndirectory \"${pal_folder}\"\nsource ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/pal_gdb.py\n")
  set(debug_lines)
  if(ARG_DEBUG_LINES)
    set(debug_lines --debug-lines)
  endif()

  set(plugin)
  set(plugin_file)
  set(declared_file)
  if(ARG_WORKCELL)
    set(plugin --plugin)
    if(ARG_DECLARED)
      get_filename_component(declared_file "${ARG_DECLARED}" ABSOLUTE)
      file(RELATIVE_PATH declared_name "${CMAKE_SOURCE_DIR}" "${declared_file}")
      list(APPEND plugin --declared ${declared_name})
    endif()
    set(plugin_file "${directory}/${prefix}_plugin.cpp")
  endif()

  set(pal_program $<TARGET_FILE:pal::pal>)
  set(pal_target pal::pal)
  if(PAL_GENERATOR)
    set(pal_program "${PAL_GENERATOR}")
    set(pal_target "${PAL_GENERATOR}")
  endif()
  add_custom_command(
    OUTPUT ${generated} ${plugin_file}
    COMMAND ${CMAKE_COMMAND} -DPAL=${pal_program} -DFILE=${pal_name} -DENVIRONMENT=${environment_name}
            -DSKILL=${ARG_SKILL} -DALLOW_FAILING=${ARG_ALLOW_FAILING} -DWITHOUT_TIMES=${ARG_WITHOUT_TIMES} -P "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/PalCheck.cmake"
    COMMAND ${pal_program} generate ${pal_name} --environment ${environment_name} --skill ${ARG_SKILL} -o "${directory}" --allow-failing ${debug_lines} ${plugin}
            --depfile "${directory}/${prefix}.d" --depfile-target "${directory}/${prefix}_messages.hpp"
            --depfile-folder "${CMAKE_SOURCE_DIR}"
    DEPENDS ${pal_target} "${pal_file}" "${environment_file}" ${declared_file} "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/PalCheck.cmake"
    DEPFILE "${directory}/${prefix}.d"
    WORKING_DIRECTORY "${CMAKE_SOURCE_DIR}"
    COMMENT "Checking skill ${ARG_SKILL} and generating its C++"
    VERBATIM)

  add_library(pal_skill_${name} STATIC ${generated} ${ARG_SOURCES})
  pal_in_plugins(pal_skill_${name})
  add_library(pal::skill_${name} ALIAS pal_skill_${name})
  target_include_directories(pal_skill_${name} PUBLIC "${directory}")
  target_link_libraries(pal_skill_${name} PUBLIC pal::runtime)
  if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # About the lambdas of coroutines, in files that the compiler sees as one.
    target_compile_options(pal_skill_${name} PRIVATE -Wno-subobject-linkage)
  endif()

  if(ARG_WORKCELL)
    add_library(pal_plugin_${name} MODULE ${plugin_file})
    pal_in_plugins(pal_plugin_${name})
    set_target_properties(pal_plugin_${name} PROPERTIES PREFIX "" OUTPUT_NAME ${name} SUFFIX .so)
    if(NOT ARG_INSTALLED)
      target_compile_definitions(pal_plugin_${name} PRIVATE PAL_SKILL_FOLDER="${CMAKE_SOURCE_DIR}")
    endif()
    target_link_libraries(pal_plugin_${name} PRIVATE pal_skill_${name})
    # Several skills, and the program that loads them, have the same runtime: each keeps its own to itself.
    target_link_options(pal_plugin_${name} PRIVATE -Wl,--exclude-libs,ALL -Wl,--no-undefined)
  endif()
endfunction()

# pal_in_plugins(TARGET): its code goes into shared libraries, and nobody replaces a function of it there.
function(pal_in_plugins target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
endfunction()
