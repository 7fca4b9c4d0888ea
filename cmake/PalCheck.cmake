# Runs `pal check` for pal_add_skill: -DPAL= -DFILE= -DENVIRONMENT= -DSKILL= -DALLOW_FAILING= -DWITHOUT_TIMES=.
# Exit status 3 means that a requirement fails, is undecided or was not checked; everything else above 0 is worse.
set(times)
if(WITHOUT_TIMES)
  set(times --without-times)
endif()
execute_process(COMMAND "${PAL}" check "${FILE}" --environment "${ENVIRONMENT}" --skill "${SKILL}" ${times}
                RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(status EQUAL 0)
  return()
endif()
message("${output}")
if(NOT (status EQUAL 3 AND ALLOW_FAILING))
  message(FATAL_ERROR "pal check ${FILE}: skill ${SKILL} did not pass (status ${status})")
endif()
