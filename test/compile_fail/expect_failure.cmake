# Builds a case as it is, which must work, and with its fault, which must fail with the expected message.
file(STRINGS ${SOURCE} expected REGEX "^// expect: ")
string(REGEX REPLACE "^// expect: " "" expected "${expected}")
if(expected STREQUAL "")
  message(FATAL_ERROR "${SOURCE} has no line `// expect: MESSAGE`")
endif()

function(build kind)
  execute_process(
    COMMAND ${CMAKE_COMMAND} --build ${BUILD_DIR} --config "${CONFIG}" --target compile_fail_${CASE}_${kind}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(result ${result} PARENT_SCOPE)
  set(output "${output}" PARENT_SCOPE)
endfunction()

build(right)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "without the fault it does not compile:\n${output}")
endif()
build(fault)
if(result EQUAL 0)
  message(FATAL_ERROR "the fault compiles")
endif()
string(FIND "${output}" "${expected}" place)
if(place EQUAL -1)
  message(FATAL_ERROR "the message `${expected}` is not in:\n${output}")
endif()
