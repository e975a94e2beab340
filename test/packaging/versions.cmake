# cmake -D ROOT=DIR -P versions.cmake: wherever a version or the date of the release is written, it is that of version.h, and
# that of the changelog.
cmake_minimum_required(VERSION 3.16)

# found(RESULT FILE REGEX): what the one group of a regular expression matches first in a file.
function(found result file regex)
  file(READ ${ROOT}/${file} text)
  if(NOT text MATCHES "${regex}")
    message(FATAL_ERROR "${file} does not match ${regex}")
  endif()
  set(${result} ${CMAKE_MATCH_1} PARENT_SCOPE)
endfunction()

function(expect value file regex)
  found(other ${file} "${regex}")
  if(NOT other STREQUAL value)
    message(SEND_ERROR "${file} has ${other}, not ${value}")
  endif()
endfunction()

set(header include/CGAL/Region_segmentation/Support/version.h)
found(version ${header} "VERSION \"([0-9.]+)\"")
string(REPLACE "." ";" numbers ${version})
foreach(part IN ITEMS MAJOR MINOR PATCH)
  list(POP_FRONT numbers number)
  expect("${number}" ${header} "VERSION_${part} ([0-9]+)")
endforeach()
expect(${version} CHANGELOG.md "\n## ([0-9.]+) ")
expect(${version} CITATION.cff "\nversion: ([0-9.]+)\n")
expect(${version} README.md "segment_mesh-([0-9.]+)-linux")
expect(${version} examples/python/pyproject.toml "\nversion = \"([0-9.]+)\"")
expect(${version} examples/npm/package.json "\"version\": \"([0-9.]+)\"")
expect(${version} cmake/packaging/vcpkg/cgal-region-segmentation/vcpkg.json "\"version\": \"([0-9.]+)\"")
expect(${version} cmake/packaging/conan/conanfile.py "version = \"([0-9.]+)\"")
expect(${version} cmake/packaging/conda-forge/recipe.yaml "version: \"([0-9.]+)\"")

found(date CHANGELOG.md "\n## [0-9.]+ \\(([0-9-]+)\\)")
expect(${date} CITATION.cff "\ndate-released: ([0-9-]+)\n")
