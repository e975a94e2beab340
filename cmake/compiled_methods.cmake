# The target CGAL::Region_segmentation_compiled, for programs of several translation units: one of
# them has the code of the methods. It is built with the flags of the project that links it;
# Smooth_faces is in it where CMake finds Eigen.
find_package(Eigen3 CONFIG QUIET)
add_library(CGAL_Region_segmentation_compiled STATIC EXCLUDE_FROM_ALL
  ${CMAKE_CURRENT_LIST_DIR}/compiled_methods.cpp)
add_library(CGAL::Region_segmentation_compiled ALIAS CGAL_Region_segmentation_compiled)
target_compile_definitions(CGAL_Region_segmentation_compiled
  PUBLIC CGAL_REGION_SEGMENTATION_COMPILED)
target_link_libraries(CGAL_Region_segmentation_compiled
  PUBLIC CGAL::Region_segmentation $<TARGET_NAME_IF_EXISTS:Eigen3::Eigen>)
