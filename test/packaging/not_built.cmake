# The headers are installed without building anything, and without GoogleTest; embedded in another
# project, as FetchContent does it, without GoogleTest and without a network, the package adds no target doc, builds no program
# and installs nothing, and the project is built and runs.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

set(settings -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${CXX} -D CGAL_DIR=${CGAL_DIR} -D CMAKE_BUILD_TYPE=Debug
    -D CMAKE_CXX_FLAGS_DEBUG=-O0)

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} -S ${PACKAGE} -B ${WORK}/package ${settings} -D CMAKE_DISABLE_FIND_PACKAGE_GTest=ON)
run(${CMAKE_COMMAND} --install ${WORK}/package --prefix ${WORK}/prefix)
if(NOT EXISTS ${WORK}/prefix/include/CGAL/region_segmentation.h)
  message(FATAL_ERROR "The headers were not installed")
endif()

file(WRITE ${WORK}/outer/CMakeLists.txt "
cmake_minimum_required(VERSION 3.16)
project(outer LANGUAGES CXX)
include(FetchContent)
FetchContent_Declare(region_segmentation SOURCE_DIR ${PACKAGE})
FetchContent_MakeAvailable(region_segmentation)
foreach(target doc segment_mesh region_segmentation_tests)
  if(TARGET \${target})
    message(FATAL_ERROR \"Embedded, the package adds the target \${target}\")
  endif()
endforeach()
add_executable(user ${CMAKE_CURRENT_LIST_DIR}/user/user.cpp)
target_link_libraries(user PRIVATE CGAL::Region_segmentation)
add_custom_target(check COMMAND user)
")
run(${CMAKE_COMMAND} -S ${WORK}/outer -B ${WORK}/embedded ${settings} -D CMAKE_DISABLE_FIND_PACKAGE_GTest=ON
    -D FETCHCONTENT_FULLY_DISCONNECTED=ON)
run(${CMAKE_COMMAND} --install ${WORK}/embedded --prefix ${WORK}/embedded_prefix)
if(EXISTS ${WORK}/embedded_prefix/include)
  message(FATAL_ERROR "Embedded, the package installs its headers")
endif()
run(${CMAKE_COMMAND} --build ${WORK}/embedded --target check)
