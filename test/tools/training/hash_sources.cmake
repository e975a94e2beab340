# cmake -D OUTPUT=FILE -D SOURCES=LIST -P hash_sources.cmake: a header with a hash of the training sources.
cmake_minimum_required(VERSION 3.16)

set(hashes)
foreach(source IN LISTS SOURCES)
  file(SHA256 ${source} hash)
  string(APPEND hashes ${hash})
endforeach()
string(SHA256 hash "${hashes}")
string(SUBSTRING ${hash} 0 16 hash)
file(WRITE ${OUTPUT} "constexpr const char* training_sources_hash = \"${hash}\";\n")
