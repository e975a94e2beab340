#!/bin/sh
# run.sh [CTEST ARGUMENT...]: builds and runs the tests; without arguments all of them.
#
# Installs what is missing and builds in release mode into build-test/. CGAL_DIR=DIR tests against
# another CGAL, in a build of its own. REGION_SEGMENTATION_PSB=DIR, the unpacked Princeton Segmentation
# Benchmark, adds the tests that need it; without it they say so and are skipped.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)

sh "$root/cmake/install_packages.sh" g++ clang make cmake doxygen libcgal-dev libcgal-demo libeigen3-dev libgtest-dev \
  libjs-mathjax libopenmesh-dev libcli11-dev libpng-dev libspectra-dev libtbb-dev libxgboost-dev parallel valgrind

build=$root/build-test
if [ -n "${CGAL_DIR:-}" ]; then
  build=$build-$(printf %s "$CGAL_DIR" | cksum | cut -d ' ' -f 1)
fi

# The meshes of CGAL's demos: real data for tests that always run.
archive=/usr/share/doc/libcgal-dev/data.tar.gz
meshes=$build/real_meshes
if [ -f "$archive" ] && [ ! -d "$meshes" ]; then
  mkdir -p "$meshes.part"
  tar -xzf "$archive" -C "$meshes.part"
  mv "$meshes.part" "$meshes"
fi
export REGION_SEGMENTATION_REAL_MESHES="$meshes"

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release ${CGAL_DIR:+"-DCGAL_DIR=$CGAL_DIR"} >/dev/null
cmake --build "$build" -j 2
ctest --test-dir "$build" --output-on-failure -j 2 "$@"
