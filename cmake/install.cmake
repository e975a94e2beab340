# Install rules and the package config: find_package(CGAL_Region_segmentation) gives the targets
# CGAL::Region_segmentation and CGAL::Region_segmentation_compiled.
include(CMakePackageConfigHelpers)

set_target_properties(CGAL_Region_segmentation PROPERTIES EXPORT_NAME Region_segmentation)
install(TARGETS CGAL_Region_segmentation EXPORT CGAL_Region_segmentation_targets)
install(DIRECTORY include/CGAL DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/CGAL_Region_segmentation)
install(EXPORT CGAL_Region_segmentation_targets NAMESPACE CGAL:: DESTINATION ${config_dir})
configure_package_config_file(cmake/CGAL_Region_segmentationConfig.cmake.in
  ${PROJECT_BINARY_DIR}/CGAL_Region_segmentationConfig.cmake
  INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/CGAL_Region_segmentationConfigVersion.cmake
  COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/CGAL_Region_segmentationConfig.cmake
              ${PROJECT_BINARY_DIR}/CGAL_Region_segmentationConfigVersion.cmake
              cmake/compiled_methods.cmake cmake/compiled_methods.cpp
        DESTINATION ${config_dir})
