# The port of the headers, from the tree that it lies in; for the registry, a source by
# vcpkg_from_github() takes the place of the first line.
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../../.." ABSOLUTE)

set(VCPKG_BUILD_TYPE release) # headers alone
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    -DREGION_SEGMENTATION_BUILD_PROGRAM=OFF
    -DREGION_SEGMENTATION_BUILD_EXAMPLES=OFF
    -DREGION_SEGMENTATION_BUILD_TESTS=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/CGAL_Region_segmentation
                         PACKAGE_NAME CGAL_Region_segmentation)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/lib")

vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
