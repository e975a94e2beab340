#!/bin/sh
# make_cgal_layout.sh DIR: makes DIR/Region_segmentation, the package in the layout of CGAL's
# repository: include, doc, examples, test and package_info, with the names and macros that its
# scripts look for. (doc/cgal_package.md says what would be submitted.)
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
name=Region_segmentation
mkdir -p "$1"
package=$(cd "$1" && pwd)/$name
if [ -e "$package" ]; then
  echo "$package is there already" >&2
  exit 1
fi
for part in doc examples test package_info; do
  mkdir -p "$package/$part/$name"
done
cp -r "$root/include" "$package/"

# programs: lines of CMake for the sources that are named on the standard input.
programs()
{
  sed 's/.*/create_single_source_cgal_program("&")/'
}

# sources DIR: its examples or tests.
sources()
{
  (cd "$1" && ls) | grep '_\(example\|test\)[.]cpp$'
}

# begin_cmake KIND: how a CMakeLists.txt begins.
begin_cmake()
{
  echo 'cmake_minimum_required(VERSION 3.12...3.29)'
  echo "project(${name}_$1)"
  echo 'find_package(CGAL REQUIRED)'
  echo 'find_package(Eigen3 3.1.0 QUIET)'
  echo 'include(CGAL_Eigen3_support)'
}

# Examples in one folder.
examples=$package/examples/$name
cp -r "$root"/examples/*.h "$root/examples/data" "$examples"
for file in "$root"/examples/*.cpp "$root"/examples/pipelines/*.cpp; do
  sed 's,"\.\./,",' "$file" >"$examples/$(basename "$file" .cpp)_example.cpp"
done
with_eigen='^\(parameterize\|machine_part\|holes\|split_and_close\)_example.cpp$'
{
  begin_cmake Examples
  sources "$examples" | grep -v "$with_eigen" | programs
  echo 'if(TARGET CGAL::Eigen3_support)'
  for file in $(sources "$examples" | grep "$with_eigen"); do
    echo "  create_single_source_cgal_program(\"$file\")"
    echo "  target_link_libraries(${file%.cpp} PRIVATE CGAL::Eigen3_support)"
  done
  echo 'else()'
  echo '  message("NOTICE: Some examples require Eigen 3.1 or later, and are not compiled.")'
  echo 'endif()'
} >"$examples/CMakeLists.txt"

# Tests, without those of the threads and of OpenMesh, which need more than CGAL and GoogleTest.
tests=$package/test/$name
cp "$root"/test/*.h "$root/test/meshes.cpp" "$root/test/oracles.cpp" "$root"/test/*_test.cpp "$tests"
rm "$tests/parallel_test.cpp" "$tests/segments_mesh_types_test.cpp" "$tests/precompiled.h"
{
  begin_cmake Tests
  echo 'find_package(GTest REQUIRED)'
  sources "$tests" | programs
  cat <<'END'
add_library(test_support STATIC EXCLUDE_FROM_ALL meshes.cpp oracles.cpp)
target_link_libraries(test_support PUBLIC CGAL::CGAL GTest::gtest_main)
if(TARGET CGAL::Eigen3_support)
  target_link_libraries(test_support PUBLIC CGAL::Eigen3_support)
  target_compile_definitions(test_support PUBLIC TEST_EIGEN)
endif()
file(GLOB tests RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} *_test.cpp)
foreach(test IN LISTS tests)
  get_filename_component(test ${test} NAME_WE)
  target_link_libraries(${test} PRIVATE test_support)
endforeach()
END
} >"$tests/CMakeLists.txt"

# The manual names examples by the package and their new names.
doc=$package/doc/$name
cp -r "$root/doc/$name/." "$doc"
rm "$doc/manual.css"
sed -i -E "s#\\\\include (pipelines/)?([a-z_]+)\\.cpp#\\\\cgalExample{$name/\\2_example.cpp}#
s#\\\\example (pipelines/)?([a-z_]+)\\.cpp#\\\\example $name/\\2_example.cpp#
s#examples/(pipelines/)?([a-z_]+)\\.cpp#$name/\\2_example.cpp#" "$doc"/*.txt
cat >"$doc/Doxyfile.in" <<'END'
@INCLUDE = ${CGAL_DOC_PACKAGE_DEFAULTS}
PROJECT_NAME = "CGAL ${CGAL_DOC_VERSION} - Region Segmentation"
INPUT = ${CGAL_PACKAGE_DOC_DIR} \
        ${CGAL_PACKAGE_INCLUDE_DIR}/CGAL
EXCLUDE = ${CGAL_PACKAGE_INCLUDE_DIR}/CGAL/Region_segmentation/Support/parameters.h
EXCLUDE_PATTERNS = */internal/*
EXCLUDE_SYMBOLS = *internal* *internal_np*
EXTRACT_STATIC = YES
END

# Maintainers are people; who they are is said when it is submitted.
info=$package/package_info/$name
echo 'Region Segmentation' >"$info/description.txt"
sed -n '/cgalPkgDesc{/,/}$/p' "$root/doc/$name/PackageDescription.txt" |
  sed 's/\\cgalPkgDesc{//; s/}$//; s/\\cgal/CGAL/g; s/`//g' >"$info/long_description.txt"
echo 'LGPL (v3 or later)' >"$info/license.txt"
echo 'to be named at submission' | tee "$info/maintainer" >"$info/copyright"
printf '%s\n' BGL Installation Kernel_23 Number_types Property_map STL_Extension Stream_support \
  "$name" >"$info/dependencies"
