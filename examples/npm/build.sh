#!/bin/sh
# build.sh [FOLDER]: makes an npm package of the library as WebAssembly,
# FOLDER/region-segmentation-VERSION.tgz, by default in build-npm/. It runs in node, from release 18
# on, and in browsers. REPOSITORY=URL: where its source is, as its package.json says then.
#
# Installs what is missing (by apt); with INSTALL_PACKAGES=no nothing is installed, and exit status 77
# says that packages are absent. npm is not installed: that of Debian and that of node's makers exclude
# each other.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "${1:-$root/build-npm}"
build=$(cd "${1:-$root/build-npm}" && pwd)

packages="emscripten libboost-dev libcgal-dev libeigen3-dev nlohmann-json3-dev node-acorn nodejs"
sh "$root/cmake/install_packages.sh" $packages
if ! command -v npm >/dev/null; then
  echo "skipped: there is no npm (Debian: npm)"
  exit 77
fi

# The headers alone: beside them in /usr/include are those of the C library of this machine.
mkdir -p "$build/include"
ln -sfn /usr/include/CGAL /usr/include/boost /usr/include/eigen3/Eigen /usr/include/nlohmann "$build/include"
cd "$root/examples/npm"
cp package.json README.md index.mjs index.d.ts "$root/LICENSE" "$build"
export NODE_PATH="/usr/share/nodejs${NODE_PATH:+:$NODE_PATH}" # acorn, which shortens the scripts
em++ -std=c++17 -O2 -ffp-contract=off -fwasm-exceptions -DNDEBUG -DCGAL_DISABLE_GMP -DCGAL_NO_GMP \
  -I "$root/include" -I "$root/examples/segment_mesh" -isystem "$build/include" engine.cpp --bind \
  -sSINGLE_FILE -sMODULARIZE -sEXPORT_ES6 -sUSE_ES6_IMPORT_META=0 -sENVIRONMENT=web,worker -sALLOW_MEMORY_GROWTH \
  -sMAXIMUM_MEMORY=4GB -sFILESYSTEM=0 -o "$build/engine.mjs"
cd "$build"
[ -z "${REPOSITORY:-}" ] || npm pkg set repository="$REPOSITORY"
npm pack --silent
