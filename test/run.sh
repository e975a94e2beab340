#!/bin/sh
# run.sh [all] [CTEST ARGUMENT...]: builds and runs the tests of the library and of the program; with `all` also those of
# the modules for Python, npm and Blender, of pages in browsers, examples, packages, documents, other compilers and
# processors, of speed and memory, of what measures and trains, with sanitizers, and short fuzzing.
#
# Installs what is missing and builds in release mode into build-test/. CGAL_DIR=DIR tests against
# another CGAL, in a build of its own. REGION_SEGMENTATION_PSB=DIR, the unpacked Princeton Segmentation
# Benchmark, adds the tests of `all` that need it; without it they say so and are skipped.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)

packages="g++ make cmake clang-format libexpat1-dev libminizip-dev libboost-iostreams-dev libcgal-demo libcgal-dev libcli11-dev libeigen3-dev
  libgtest-dev libjs-three libmeshoptimizer-dev libopenmesh-dev libpng-dev librapidcheck-dev libtbb-dev nlohmann-json3-dev python3 zlib1g-dev"
all=OFF
if [ "${1:-}" = all ]; then
  shift
  all=ON
  packages="$packages assimp-utils blender calculix-ccx chromium chromium-driver clang dpkg-dev doxygen emscripten
    g++-aarch64-linux-gnu gmsh libclang-rt-14-dev libfast-float-dev libjs-mathjax libocct-data-exchange-dev lintian mypy node-acorn
    node-typescript nodejs openfoam parallel prusa-slicer python3-dev python3-gmsh python3-hypothesis python3-meshio python3-numpy python3-pip
    python3-pybind11 python3-pytest python3-selenium python3-setuptools python3-vtk9 qemu-user-static valgrind"
  # That of node's makers is part of their nodejs, which excludes Debian's.
  command -v npm >/dev/null || packages="$packages npm"
fi
sh "$root/cmake/install_packages.sh" $packages

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

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DREGION_SEGMENTATION_BUILD_EXAMPLES=OFF \
  -DREGION_SEGMENTATION_ALL_TESTS=$all ${CGAL_DIR:+"-DCGAL_DIR=$CGAL_DIR"} >/dev/null
cmake --build "$build" -j 2
ctest --test-dir "$build" --output-on-failure -j 2 "$@"
