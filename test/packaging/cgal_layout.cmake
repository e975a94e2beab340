# The tree in the layout of CGAL's repository: two examples that need Eigen and a test are built and run there, as CGAL's scripts
# build them (the test examples_alone compiles all examples of this layout), and Doxygen runs over the documentation without a
# warning. DOXYFILE is that of this repository, whose settings and aliases stand
# for those of CGAL's packages.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)
set(package ${WORK}/Region_segmentation)

file(REMOVE_RECURSE ${WORK})
run(sh ${SOURCE}/cmake/make_cgal_layout.sh ${WORK})

function(build_and_run kind)
  set(source ${package}/${kind}/Region_segmentation)
  # In CGAL's repository the include folders of all packages are in the path.
  run(${CMAKE_COMMAND} -S ${source} -B ${WORK}/build_${kind} -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${CXX} -D CGAL_DIR=${CGAL_DIR}
      -D CMAKE_BUILD_TYPE=Debug -D CMAKE_CXX_FLAGS_DEBUG=-O0 -D CMAKE_CXX_FLAGS=-I${package}/include)
  file(GLOB programs RELATIVE ${source} ${source}/*_*.cpp)
  list(FILTER programs EXCLUDE REGEX "^(meshes|oracles)[.]cpp$")
  run(${CMAKE_COMMAND} --build ${WORK}/build_${kind} --target help)
  foreach(program IN LISTS programs)
    string(REPLACE ".cpp" "" program ${program})
    if(NOT run_output MATCHES "${program}")
      message(FATAL_ERROR "${kind}: ${program} is not built")
    endif()
  endforeach()
  foreach(program IN LISTS ARGN)
    run(${CMAKE_COMMAND} --build ${WORK}/build_${kind} --target ${program})
    run(${WORK}/build_${kind}/${program})
  endforeach()
endfunction()
set(ENV{CGAL_DATA_DIR} ${package}/examples/Region_segmentation/data)
build_and_run(examples machine_part_example write_a_method_example)
build_and_run(test Partition_test)

if(NOT EXISTS ${DOXYFILE})
  message("There is no ${DOXYFILE}, and so no Doxygen: the documentation is not checked")
  return()
endif()
set(CGAL_DOC_PACKAGE_DEFAULTS ${DOXYFILE})
set(CGAL_PACKAGE_DOC_DIR ${package}/doc/Region_segmentation)
set(CGAL_PACKAGE_INCLUDE_DIR ${package}/include)
configure_file(${package}/doc/Region_segmentation/Doxyfile.in ${WORK}/Doxyfile)
file(APPEND ${WORK}/Doxyfile "
OUTPUT_DIRECTORY = ${WORK}
EXAMPLE_PATH = ${package}/examples
IMAGE_PATH = ${package}/doc/Region_segmentation/fig
STRIP_FROM_PATH = ${package}/include ${package}/doc/Region_segmentation
STRIP_FROM_INC_PATH = ${package}/include ${package}/doc/Region_segmentation/Concepts
")
run(doxygen ${WORK}/Doxyfile)
if(NOT EXISTS ${WORK}/html/Region_segmentation_2segment_surface_mesh_example_8cpp-example.html)
  message(FATAL_ERROR "The documentation has no page of an example")
endif()
