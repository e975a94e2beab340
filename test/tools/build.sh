#!/bin/sh
# build.sh BUILD TARGET...: builds what measures and trains, without tests.
set -eu
build=$1
shift
cmake -S "$(dirname "$0")/../.." -B "$build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O3 -DNDEBUG" \
  -DREGION_SEGMENTATION_BUILD_PROGRAM=OFF -DREGION_SEGMENTATION_BUILD_EXAMPLES=OFF -DREGION_SEGMENTATION_BUILD_TESTS=OFF \
  -DREGION_SEGMENTATION_BUILD_BENCHMARKS=ON >/dev/null
cmake --build "$build" --target "$@" >&2
