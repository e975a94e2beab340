# Run by CPack on what it is to pack: adds what Debian's policy asks for, and the examples.
set(source ${CMAKE_CURRENT_LIST_DIR}/..)

set(doc ${CPACK_TEMPORARY_DIRECTORY}/headers/usr/share/doc/${CPACK_DEBIAN_HEADERS_PACKAGE_NAME})
foreach(folder IN ITEMS examples examples/data examples/pipelines examples/pipelines/mesh_to_step)
  file(GLOB examples ${source}/${folder}/*.cpp ${source}/${folder}/*.h ${source}/${folder}/*.off
    ${source}/${folder}/*.geo)
  file(COPY ${examples} DESTINATION ${doc}/${folder})
endforeach()

string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper)
  set(name ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(usr ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr)
  set(changelog ${usr}/share/doc/${name}/changelog.Debian)
  set(version ${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
  file(WRITE ${changelog} "${name} (${version}) unstable; urgency=medium

  * Version ${CPACK_PACKAGE_VERSION}.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
  file(WRITE ${usr}/share/doc/${name}/copyright
"Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: CGAL_Region_segmentation

Files: *
Copyright: the contributors of CGAL_Region_segmentation
License: LGPL-3+ and GPL-3+
 The headers are LGPL-3.0-or-later, the program and the examples
 GPL-3.0-or-later, as each file says. On Debian systems the texts are in
 /usr/share/common-licenses/LGPL-3 and /usr/share/common-licenses/GPL-3.

Files: three.js, in the program and in the pages that it writes
Copyright: the authors of three.js
License: Expat
 On Debian systems the text is in /usr/share/doc/libjs-three/copyright.
")
  file(GLOB_RECURSE manuals ${usr}/share/man/*.1)
  execute_process(COMMAND gzip -9 -n ${changelog} ${manuals} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
