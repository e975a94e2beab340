# Runs PROGRAM under VALGRIND in the folder WORK. `counts`: a list of "NAME: INSTRUCTIONS", one for each of its dumps,
# sorted; `output`: what it printed.

# Without these, glibc's functions for memory and mathematics depend on the processor.
set(ENV{GLIBC_TUNABLES} "glibc.cpu.hwcaps=-AVX2,-AVX,-FMA,-FMA4,-AVX512F,-SSE4_1,-SSE4_2,-SSSE3,-ERMS,-FSRM")
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
execute_process(
  COMMAND ${VALGRIND} --tool=callgrind --instr-atstart=no --callgrind-out-file=${WORK}/counts ${PROGRAM}
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "The program fails under callgrind: ${result}\n${output}")
endif()

# Each dump says what triggered it, and its total.
set(counts)
file(GLOB dumps ${WORK}/counts.*)
foreach(dump IN LISTS dumps)
  file(STRINGS ${dump} trigger REGEX "^desc: Trigger: Client Request: ")
  file(STRINGS ${dump} total REGEX "^totals: ")
  if(trigger AND total MATCHES "([0-9]+)")
    set(count ${CMAKE_MATCH_1})
    string(REPLACE "desc: Trigger: Client Request: " "" name "${trigger}")
    list(APPEND counts "${name}: ${count}")
  endif()
endforeach()
list(SORT counts)
if(NOT counts)
  message(FATAL_ERROR "callgrind wrote no counts:\n${output}")
endif()
