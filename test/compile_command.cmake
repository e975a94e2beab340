# compile_command(RESULT): the command, as a list, with which CMake would compile SOURCE, from COMMANDS, a
# compile_commands.json; it also holds what is built by no target.
function(compile_command result)
  # Each command has a line of its own, and ends with the source.
  file(STRINGS ${COMMANDS} command REGEX "^ *\"command\": .* ${SOURCE}\",$")
  if(command STREQUAL "")
    message(FATAL_ERROR "${COMMANDS} has no command for ${SOURCE}")
  endif()
  string(REGEX REPLACE "^ *\"command\": \"(.*)\",$" "\\1" command "${command}")
  string(REPLACE "\\\"" "\"" command "${command}")
  separate_arguments(command UNIX_COMMAND "${command}")
  set(${result} "${command}" PARENT_SCOPE)
endfunction()
