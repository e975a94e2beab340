#!/bin/sh
# quick.sh: builds and runs the tests of the library's core in minutes: surfaces, links, the default method, and two-step
# against its reference. Shares build-test/ with run.sh.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
sh "$root/cmake/install_packages.sh" g++ make cmake libcgal-dev libgtest-dev
cmake -S "$root" -B "$root/build-test" -DCMAKE_BUILD_TYPE=Release -DREGION_SEGMENTATION_BUILD_EXAMPLES=OFF >/dev/null
cmake --build "$root/build-test" -j 2 --target region_segmentation_quick_test
"$root/build-test/bin/region_segmentation_quick_test" --gtest_brief=1 --gtest_filter='-*Real_meshes*'
