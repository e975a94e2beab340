# cmake -D PROGRAM=FILE -D PIPELINE=NAME -D MESH=NAME -P run_on_real_mesh.cmake: runs the pipeline of the program on a mesh of
# CGAL's demos.
cmake_minimum_required(VERSION 3.16)

file(GLOB_RECURSE files "$ENV{REGION_SEGMENTATION_REAL_MESHES}/*/${MESH}")
if("$ENV{REGION_SEGMENTATION_REAL_MESHES}" STREQUAL "" OR NOT files)
  message(STATUS "REGION_SEGMENTATION_REAL_MESHES names no folder with ${MESH}")
  return()
endif()
list(GET files 0 file)
execute_process(COMMAND ${PROGRAM} ${PIPELINE} ${file} RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${PIPELINE} ${file}: ${result}")
endif()
