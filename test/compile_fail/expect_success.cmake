# Parses the cases as they are, which must work.
include(${CMAKE_CURRENT_LIST_DIR}/parse.cmake)
parse()
if(NOT result EQUAL 0)
  message(FATAL_ERROR "without the fault it does not compile:\n${output}")
endif()
