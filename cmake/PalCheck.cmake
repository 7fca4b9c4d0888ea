# Runs `pal check` for pal_add_skill: -DPAL= -DFILE= -DENVIRONMENT= -DSKILL= -DALLOW_FAILING=.
# Exit status 3 means that a requirement fails or is undecided; everything else above 0 is worse.
execute_process(COMMAND "${PAL}" check "${FILE}" --environment "${ENVIRONMENT}" --skill "${SKILL}"
                RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(status EQUAL 0)
  return()
endif()
message("${output}")
if(NOT (status EQUAL 3 AND ALLOW_FAILING))
  message(FATAL_ERROR "pal check ${FILE}: skill ${SKILL} did not pass (status ${status})")
endif()
