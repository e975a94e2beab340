# Parses SOURCE, with the command of COMMANDS, as it is, which must work, and with the faults: the messages of the compiler
# become the file MESSAGES, without the characters that are special in lists.
include(${CMAKE_CURRENT_LIST_DIR}/../compile_command.cmake)
compile_command(command)
file(REMOVE ${MESSAGES})

execute_process(COMMAND ${command} -fsyntax-only RESULT_VARIABLE result ERROR_VARIABLE output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "without the faults it does not compile:\n${output}")
endif()
execute_process(COMMAND ${command} -fsyntax-only -DWITH_FAULT RESULT_VARIABLE result ERROR_VARIABLE output)
if(result EQUAL 0)
  message(FATAL_ERROR "the faults compile")
endif()
string(REGEX REPLACE "[][;]" "_" output "${output}")
file(WRITE ${MESSAGES} "${output}")
