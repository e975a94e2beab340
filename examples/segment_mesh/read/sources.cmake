# From the bytes of a file to a soup, without files and CGAL: for the program, the page of examples/web/ and fuzzing.
set(reading_sources Gltf_file.cpp Text_scanner.cpp read_gltf.cpp read_mesh.cpp read_obj.cpp read_off.cpp read_ply.cpp read_stl.cpp)
