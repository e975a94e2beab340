# segment_mesh_make_page(PAGE THREE EXAMPLES NAME=FILE|FILE...): a command that makes a page from page.html, where each {{NAME}} becomes the
# texts of its files, one after the other; THREE and EXAMPLES are the folders of three.js and of its examples. As a script, this is what the command runs.
set(page_folder ${CMAKE_CURRENT_LIST_DIR})

function(segment_mesh_make_page page three examples)
  set(parts ${ARGN}
    "THREE=${three}/three.min.js"
    "CONTROLS=${examples}/controls/TrackballControls.js"
    "EXPORTER=${examples}/exporters/GLTFExporter.js"
    "READ_ARRAYS=${page_folder}/read_arrays.js"
    "MERGE_TREE=${page_folder}/merge_tree.js"
    "MESH_VIEW=${page_folder}/mesh_view.js"
    "PAGE=${page_folder}/page.js")
  set(files ${parts})
  list(TRANSFORM files REPLACE "^[A-Z_]+=" "")
  string(REPLACE "|" ";" files "${files}")
  list(FILTER files EXCLUDE REGEX "^$")
  add_custom_command(OUTPUT ${page}
    COMMAND ${CMAKE_COMMAND} -D PAGE=${page} "-DPARTS=${parts}" -P ${page_folder}/make_page.cmake
    DEPENDS ${files} ${page_folder}/page.html ${page_folder}/make_page.cmake
    VERBATIM)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE)
  file(READ ${page_folder}/page.html page)
  foreach(part IN LISTS PARTS)
    string(REGEX MATCH "^([A-Z_]+)=(.*)$" matched "${part}")
    set(name ${CMAKE_MATCH_1})
    string(REPLACE "|" ";" files "${CMAKE_MATCH_2}")
    set(text)
    foreach(file IN LISTS files)
      file(READ ${file} more)
      string(APPEND text "${more}")
    endforeach()
    string(REPLACE "{{${name}}}" "${text}" page "${page}")
  endforeach()
  file(WRITE ${PAGE} "${page}")
endif()
