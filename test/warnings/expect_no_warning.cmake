# Parses SOURCE by COMPILER, with the options and include folders of COMMANDS.
include(${CMAKE_CURRENT_LIST_DIR}/../compile_command.cmake)
compile_command(command)
list(POP_FRONT command)
execute_process(
  COMMAND ${COMPILER} ${command} -std=c++17 -fsyntax-only
          -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Werror
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${output}")
endif()
