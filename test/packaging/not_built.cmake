# The headers are installed without building anything, and without GoogleTest; embedded in another
# project, the package adds no target doc, builds no program and installs nothing.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

set(settings -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${CXX} -D CGAL_DIR=${CGAL_DIR} -D CMAKE_BUILD_TYPE=Release)

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} -S ${PACKAGE} -B ${WORK}/package ${settings} -D CMAKE_DISABLE_FIND_PACKAGE_GTest=ON)
run(${CMAKE_COMMAND} --install ${WORK}/package --prefix ${WORK}/prefix)
if(NOT EXISTS ${WORK}/prefix/include/CGAL/region_segmentation.h)
  message(FATAL_ERROR "The headers were not installed")
endif()

file(WRITE ${WORK}/outer/CMakeLists.txt "
cmake_minimum_required(VERSION 3.16)
project(outer LANGUAGES CXX)
add_subdirectory(${PACKAGE} package)
foreach(target doc segment_mesh region_segmentation_tests)
  if(TARGET \${target})
    message(FATAL_ERROR \"Embedded, the package adds the target \${target}\")
  endif()
endforeach()
if(NOT TARGET CGAL::Region_segmentation)
  message(FATAL_ERROR \"Embedded, the package does not add CGAL::Region_segmentation\")
endif()
")
run(${CMAKE_COMMAND} -S ${WORK}/outer -B ${WORK}/embedded ${settings})
run(${CMAKE_COMMAND} --install ${WORK}/embedded --prefix ${WORK}/embedded_prefix)
if(EXISTS ${WORK}/embedded_prefix/include)
  message(FATAL_ERROR "Embedded, the package installs its headers")
endif()
