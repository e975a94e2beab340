#!/bin/sh
# full.sh [FOLDER]: the long forms of the tests, hours of them, in FOLDER (default: build-full/): the whole suite with the
# sanitizers of clang, with CGAL's checks and without; other releases of CGAL, compilers and standards; mutation;
# coverage; the packages of a release, made and run in a bare system. Stops at the first that fails.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
work=${1:-$root/build-full}
mkdir -p "$work"
sh "$root/cmake/install_packages.sh" clang clang-tools llvm freecad-python3 g++ cmake gcovr make python3 libcgal-dev libeigen3-dev \
  libgtest-dev libocct-data-exchange-dev libopenmesh-dev libcli11-dev libpng-dev librapidcheck-dev libtbb-dev nlohmann-json3-dev \
  python3-gmsh python3-numpy debootstrap

suite() # NAME COMPILER BUILD-TYPE FLAGS CTEST-ARGUMENT...
{
  build=$work/$1
  cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE="$3" -DREGION_SEGMENTATION_ALL_TESTS=ON -DCMAKE_CXX_COMPILER="$2" \
    -DCMAKE_CXX_FLAGS="$4" >/dev/null
  cmake --build "$build" -j 2
  shift 4
  ctest --test-dir "$build" --output-on-failure -j 2 -LE build "$@"
}

export ASAN_OPTIONS=detect_stack_use_after_return=1 UBSAN_OPTIONS=print_stacktrace=1
sanitizers="-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer -g1 -D_GLIBCXX_ASSERTIONS"
suite release clang++ Release "$sanitizers"
suite debug clang++ Debug "$sanitizers -O1"
MATRIX_DIR=$work/matrix sh "$root/test/matrix/matrix.sh"
python3 "$root/test/mutation/mutate.py" --work "$work/mutation" --at-least 90
suite coverage g++ Debug "--coverage -O1 -g0 -DNDEBUG -fno-inline" -E instruction
sh "$root/cmake/release.sh" "$work/release"
sh "$root/test/packaging/bare_chroot.sh" "$work/release" || [ $? -eq 77 ]
cd "$root"
gcovr --filter include/ --filter examples/segment_mesh/ --exclude-throw-branches "$work/coverage"
