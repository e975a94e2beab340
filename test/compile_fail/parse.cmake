include(${CMAKE_CURRENT_LIST_DIR}/../compile_command.cmake)

# parse([DEFINITION...]): parses SOURCE with the command of COMMANDS; gives `result` and `output`.
function(parse)
  compile_command(command)
  execute_process(COMMAND ${command} -fsyntax-only ${ARGV}
                  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(result ${result} PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()
