# cmake -DPROGRAM=... -DSOURCE=planted.cu -DMISTAKE=name [-DWORDS=regex] -P planted.cmake
#
# Runs the program with one mistake and asks that it fails, and names the line marked with it and
# the words. Without a mistake it must succeed and report nothing.
execute_process(COMMAND ${PROGRAM} ${MISTAKE} RESULT_VARIABLE status OUTPUT_VARIABLE output
                ERROR_VARIABLE output)
if(MISTAKE STREQUAL "nothing")
    if(NOT status EQUAL 0 OR output MATCHES "WARNING|ERROR|error")
        message(FATAL_ERROR "a correct program was reported (${status}):\n${output}")
    endif()
    return()
endif()

file(READ ${SOURCE} text)
string(FIND "${text}" "// MISTAKE ${MISTAKE}\n" place)
string(SUBSTRING "${text}" 0 ${place} before)
string(REGEX MATCHALL "\n" newlines "${before}")
list(LENGTH newlines line)
math(EXPR line "${line} + 1")
if(status EQUAL 0)
    message(FATAL_ERROR "the mistake was not found:\n${output}")
elseif(NOT output MATCHES "planted\\.cu:${line}[^0-9]")
    message(FATAL_ERROR "line ${line} is not named:\n${output}")
elseif(NOT output MATCHES "${WORDS}")
    message(FATAL_ERROR "the report does not say '${WORDS}':\n${output}")
endif()
