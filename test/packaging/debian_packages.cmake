# Makes the Debian packages; lintian finds no error in them; unpacked in a folder of their own, the program runs, and a project
# that uses the headers is configured, built and run. What lintian warns about is printed.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

foreach(tool IN ITEMS dpkg-deb dpkg-shlibdeps lintian)
  find_program(found_${tool} ${tool})
  if(NOT found_${tool})
    message("Skipped: there is no ${tool} (Debian: dpkg-dev lintian)")
    return()
  endif()
endforeach()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_CPACK_COMMAND} -G DEB --config ${PACKAGE_BUILD}/CPackConfig.cmake -B ${WORK}
    -D "CPACK_PACKAGE_CONTACT=a test")
set(listed)
foreach(name IN ITEMS libcgal-region-segmentation-dev segment-mesh)
  file(GLOB package ${WORK}/${name}_${VERSION}-1_*.deb)
  run(dpkg-deb -c ${package})
  string(APPEND listed "${run_output}")
  # Who packages names a maintainer with an address; a test has none.
  execute_process(COMMAND lintian --allow-root --fail-on error
      --suppress-tags malformed-contact,syntax-error-in-debian-changelog ${package}
    RESULT_VARIABLE result OUTPUT_VARIABLE remarks)
  message("${remarks}")
  if(result)
    message(FATAL_ERROR "lintian finds errors in ${package}")
  endif()
  run(dpkg-deb -x ${package} ${WORK}/root)
endforeach()
foreach(file IN ITEMS include/CGAL/region_segmentation.h bin/segment_mesh share/man/man1/segment_mesh.1.gz
        share/doc/libcgal-region-segmentation-dev/examples/segment_surface_mesh.cpp
        share/doc/libcgal-region-segmentation-dev/examples/pipelines/remesh.cpp)
  if(NOT listed MATCHES " ./usr/${file}\n")
    message(FATAL_ERROR "No package has usr/${file}:\n${listed}")
  endif()
endforeach()

run(${WORK}/root/usr/bin/segment_mesh --demo -q -o ${WORK}/demo.seg)
run_user(${WORK}/root/usr check)
