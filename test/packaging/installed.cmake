# Installs the package to a folder of its own, then configures, builds and runs a project that uses it with the methods compiled
# once, of which its own translation unit has no code.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${PACKAGE_BUILD} --config "${CONFIG}" --prefix ${WORK}/prefix)
run_user(${WORK}/prefix check_compiled)
file(GLOB_RECURSE object ${WORK}/build/*user.cpp.o)
run(nm -C ${object})
foreach(function IN ITEMS "build_surface<" "Two_step>::prepare" "Two_step>::merge" "Learned_merging>::merge")
  if(NOT run_output MATCHES " U [^\n]*${function}")
    message(FATAL_ERROR "${function} is not left to the unit of the methods")
  endif()
endforeach()
if(run_output MATCHES "Patch_builder|find_links")
  message(FATAL_ERROR "The user's unit has code of the methods")
endif()
