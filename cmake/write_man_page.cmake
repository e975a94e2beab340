# cmake -D PROGRAM=segment_mesh -D PAGE=segment_mesh.1 -P write_man_page.cmake:
# doc/segment_mesh.1.in with all of the help of the program in it, as it is.
execute_process(COMMAND ${PROGRAM} --help all OUTPUT_VARIABLE help)
execute_process(COMMAND ${PROGRAM} --version OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE)
string(REPLACE "\\" "\\e" help "${help}")
string(REPLACE "-" "\\-" help "${help}")
string(REPLACE "'" "\\(aq" help "${help}")
configure_file(${CMAKE_CURRENT_LIST_DIR}/../doc/segment_mesh.1.in ${PAGE} @ONLY)
