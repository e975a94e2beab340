# The target CGAL::Region_segmentation_compiled, for programs of several translation units: one of
# them has the code of the methods. It is built with the flags of the project that links it;
# Smooth_faces is in it where CMake finds Eigen.
find_package(Eigen3 CONFIG QUIET)

# Such a target; the guards on speed have another, with flags of their own.
function(CGAL_Region_segmentation_add_compiled_methods target)
  add_library(${target} STATIC EXCLUDE_FROM_ALL
    ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/compiled_methods.cpp)
  target_compile_definitions(${target} PUBLIC CGAL_REGION_SEGMENTATION_COMPILED)
  target_link_libraries(${target}
    PUBLIC CGAL::Region_segmentation $<TARGET_NAME_IF_EXISTS:Eigen3::Eigen>)
endfunction()

CGAL_Region_segmentation_add_compiled_methods(CGAL_Region_segmentation_compiled)
add_library(CGAL::Region_segmentation_compiled ALIAS CGAL_Region_segmentation_compiled)
