# cmake -D CMAKE_PROJECT_INCLUDE=cmake/static_program.cmake: segment_mesh as one file that needs no
# library of the machine it runs on. It runs on one thread, and does not read what meshoptimizer has
# compressed: of these libraries Debian has no static ones.
set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
set(CGAL_Boost_USE_STATIC_LIBS ON)
set(CMAKE_DISABLE_FIND_PACKAGE_TBB ON)
set(CMAKE_DISABLE_FIND_PACKAGE_meshoptimizer ON)
add_link_options(-static -s)
