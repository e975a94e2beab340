# The pictures that segment_mesh and the benchmarks make, as a library of its own: it needs libpng and
# nothing of CGAL.
include_guard(GLOBAL)
find_package(PNG REQUIRED)

add_library(segment_mesh_view STATIC
  ${CMAKE_CURRENT_LIST_DIR}/Ink.cpp
  ${CMAKE_CURRENT_LIST_DIR}/Sample_buffer.cpp
  ${CMAKE_CURRENT_LIST_DIR}/Scene.cpp
  ${CMAKE_CURRENT_LIST_DIR}/choose_viewpoint.cpp
  ${CMAKE_CURRENT_LIST_DIR}/light_corners.cpp
  ${CMAKE_CURRENT_LIST_DIR}/reduce_colors.cpp
  ${CMAKE_CURRENT_LIST_DIR}/render_view.cpp
  ${CMAKE_CURRENT_LIST_DIR}/write_png.cpp)
target_compile_features(segment_mesh_view PUBLIC cxx_std_17)
target_include_directories(segment_mesh_view PUBLIC ${CMAKE_CURRENT_LIST_DIR})
target_link_libraries(segment_mesh_view PRIVATE PNG::PNG)
