#!/bin/sh
# build.sh [FOLDER]: builds FOLDER/segment_mesh.html, by default build-web/segment_mesh.html: a page that segments the meshes
# that are dropped on it. It needs no other file, no server and no network.
#
# Installs what is missing (by apt); with INSTALL_PACKAGES=no nothing is installed, and exit status 77 says that packages are absent.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
build=${1:-$root/build-web}

packages="cmake emscripten libboost-dev libcgal-dev libeigen3-dev libfast-float-dev libjs-three make nlohmann-json3-dev node-acorn nodejs"
sh "$root/cmake/install_packages.sh" $packages

# The headers alone: beside them in /usr/include are those of the C library of this machine.
mkdir -p "$build/include"
ln -sfn /usr/include/boost /usr/include/CGAL /usr/include/eigen3/Eigen /usr/include/fast_float /usr/include/nlohmann \
  "$build/include"

export NODE_PATH="/usr/share/nodejs${NODE_PATH:+:$NODE_PATH}" # acorn, which shortens the scripts
emcmake cmake -S "$root/examples/web" -B "$build" -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$build" -j "${JOBS:-2}"
ls -l "$build/segment_mesh.html"
