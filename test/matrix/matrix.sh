#!/bin/sh
# matrix.sh [NUMBER...]: builds and runs the core of the tests in combinations of releases of CGAL, compilers, language
# standards and optional libraries: in those of the given numbers, or in all. They meet every pair of choices. One
# combination with each release also builds and runs the pipelines of the examples, on real meshes where the environment
# variable REGION_SEGMENTATION_REAL_MESHES names them.
#
# The releases of CGAL are that of the system, and those of other Debian suites: apt fetches the headers from the machine's
# own sources with the name of the suite changed, and they are unpacked beside the system, in build-matrix/ (or
# MATRIX_DIR). Where that cannot be done, the combinations with it are skipped with a word.
#
# Exit status: 0 all passed; 1 one failed; 77 nothing was run.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
work=${MATRIX_DIR:-$root/build-matrix}

#  CGAL   compiler standard checks TBB Eigen OpenMesh pipelines
combinations="
1  system g++     20 OFF ON  ON  OFF ON
2  system clang++ 17 OFF OFF ON  ON  OFF
3  system g++     20 ON  OFF OFF ON  OFF
4  system clang++ 17 ON  ON  OFF OFF OFF
5  trixie clang++ 20 ON  OFF ON  ON  OFF
6  trixie g++     17 ON  ON  OFF ON  OFF
7  trixie g++     17 OFF ON  ON  OFF ON
8  trixie clang++ 20 OFF OFF OFF OFF OFF
9  sid    clang++ 17 ON  OFF OFF ON  OFF
10 sid    g++     17 OFF ON  ON  ON  ON
11 sid    g++     20 OFF ON  OFF OFF OFF
12 sid    clang++ 20 ON  OFF ON  OFF OFF
"

# A pair that is missing would go unnoticed.
echo "$combinations" | awk '
  NF { for (i = 2; i < NF; ++i) { value[i, $i] = 1; for (j = 2; j < i; ++j) pair[i, $i, j, $j] = 1 } }
  END {
    for (a in value) for (b in value) {
      split(a, x, SUBSEP); split(b, y, SUBSEP)
      if (x[1] > y[1] && !((x[1], x[2], y[1], y[2]) in pair)) { print "no combination has " x[2] " and " y[2]; exit 1 }
    }
  }'

# unpack SUITE: the headers and CMake files of CGAL in $work/SUITE/root, once.
unpack()
{
  folder=$work/$1
  [ ! -d "$folder/root" ] || return 0
  command -v apt-get >/dev/null && [ -r /etc/os-release ] || return 1
  own_suite=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
  [ -n "$own_suite" ] || return 1
  rm -rf "$folder"
  mkdir -p "$folder/sources" "$folder/lists/partial" "$folder/cache/archives/partial"
  # Of both formats of apt, the entries of the system's own suite alone; its updates have other names elsewhere.
  for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    [ ! -r "$file" ] || awk -v own="$own_suite" -v suite="$1" '
      /^deb / { for (i = 3; i <= NF; ++i) if ($i == own) { $i = suite; print; next } }' "$file" >>"$folder/sources/own.list"
  done
  for file in /etc/apt/sources.list.d/*.sources; do
    [ ! -r "$file" ] || awk -v RS= -v ORS="\n\n" -v own="$own_suite" -v suite="$1" '
      $0 ~ "(^|\n)Suites:[^\n]*[ \t]" own "([ \t\n]|$)" { gsub("(^|\n)Suites:[^\n]*", "\nSuites: " suite); print }' \
      "$file" >>"$folder/sources/own.sources"
  done
  : >"$folder/status" # as if nothing were installed: any release can be fetched
  set -- -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$folder/sources" -o Dir::State::lists="$folder/lists" \
    -o Dir::Cache="$folder/cache" -o Dir::State::status="$folder/status" -o Debug::NoLocking=1 -qq
  apt-get "$@" update >"$folder/apt.log" 2>&1 || return 1
  (cd "$folder" && apt-get "$@" download libcgal-dev >>apt.log 2>&1) || return 1
  dpkg-deb -x "$folder"/libcgal-dev_*.deb "$folder/part" && mv "$folder/part" "$folder/root"
}

# run NUMBER CGAL COMPILER STANDARD CHECKS TBB EIGEN OPENMESH PIPELINES
run()
{
  if ! command -v "$3" >/dev/null; then
    echo "$1: skipped: no $3"
    return
  fi
  cgal_dir=
  if [ "$2" != system ]; then
    if ! unpack "$2"; then
      echo "$1: skipped: apt does not give the CGAL of $2"
      return
    fi
    cgal_dir=$(dirname "$(find "$work/$2/root" -name CGALConfig.cmake)")
  fi
  build=$work/build-$1
  if [ "$5" = ON ]; then flags=; else flags=-DNDEBUG; fi
  tested=$((tested + 1))
  if cmake -S "$root/test/matrix" -B "$build" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER="$3" -DCMAKE_CXX_STANDARD="$4" \
       -DCMAKE_CXX_EXTENSIONS=OFF -DCMAKE_CXX_FLAGS="$flags" -DMATRIX_TBB="$6" -DMATRIX_EIGEN="$7" -DMATRIX_OPENMESH="$8" \
       -DMATRIX_PIPELINES="$9" \
       ${cgal_dir:+"-DCGAL_DIR=$cgal_dir"} >"$build.log" 2>&1 &&
     cmake --build "$build" -j "${MATRIX_JOBS:-2}" >>"$build.log" 2>&1 && "$build/matrix_test" >>"$build.log" 2>&1 &&
     (cd "$build" && ctest --output-on-failure >>"$build.log" 2>&1); then
    echo "$1: passed: $(sed -n 's/^-- matrix: //p' "$build.log"), $3, C++$4, checks $5, TBB $6, Eigen $7, OpenMesh $8, pipelines $9:" \
      "$(sed -n 's/^\[=*\] \(.*\) ran\..*/\1/p' "$build.log")"
  else
    failed=$((failed + 1))
    echo "$1: FAILED: CGAL of $2, $3, C++$4, checks $5, TBB $6, Eigen $7, OpenMesh $8, pipelines $9; the end of $build.log:"
    grep -E 'error|FAILED|warning' "$build.log" | head -20
    tail -5 "$build.log"
  fi
}

mkdir -p "$work"
tested=0
failed=0
for number in ${*:-1 2 3 4 5 6 7 8 9 10 11 12}; do
  row=$(echo "$combinations" | awk -v number="$number" '$1 == number')
  if [ -z "$row" ]; then
    echo "usage: sh test/matrix/matrix.sh [NUMBER...], numbers from 1 to 12" >&2
    exit 2
  fi
  run $row
done
[ $failed = 0 ] || exit 1
[ $tested != 0 ] || exit 77
