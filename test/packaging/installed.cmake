# Installs the package to a folder of its own, then configures, builds and runs a project that uses it.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${PACKAGE_BUILD} --config "${CONFIG}" --prefix ${WORK}/prefix)
run_user(${WORK}/prefix)
