# Debian packages by `cpack -G DEB -D CPACK_PACKAGE_CONTACT="NAME <ADDRESS>"` in the build folder:
# the headers, with the examples; and, where it was built, the program.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/add_debian_files.cmake)
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON) # else CPack builds the tests

set(CPACK_COMPONENTS_ALL headers)
if(TARGET segment_mesh)
  list(APPEND CPACK_COMPONENTS_ALL program)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_HEADERS_PACKAGE_NAME libcgal-region-segmentation-dev)
set(CPACK_DEBIAN_HEADERS_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_HEADERS_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_HEADERS_PACKAGE_DEPENDS "libcgal-dev (>= 5.5), libboost-dev (>= ${least_boost})")
set(CPACK_DEBIAN_HEADERS_PACKAGE_SUGGESTS "libeigen3-dev, libtbb-dev")
set(CPACK_DEBIAN_HEADERS_DESCRIPTION
"Segments surface meshes and polygon soups into the parts that people see, or
the faces of a machine part. It takes every model of the face graph concepts
of CGAL, and points and polygons that need not be a manifold.")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME segment-mesh)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
"Reads OFF, OBJ, PLY, STL and glTF files, and writes the parts as colored
meshes, labels, tables, pictures, and pages to view them in a browser.")

include(CPack)
