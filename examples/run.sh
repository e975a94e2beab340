#!/bin/sh
# run.sh [MESH] [K]: segments a mesh into K parts; without a mesh, the model of the program, a figure of ten parts.
#
# Installs what is missing by apt, or, where there is no apt, says what is; builds the program into build/, unless it is
# there, and runs it. The result is written in the folder from which this is called: NAME_segments.ply, with a color for
# each part, and NAME.html, a page to view and rotate them in a browser.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)

if [ $# -gt 2 ]; then
  echo "usage: sh examples/run.sh [MESH] [K]" >&2
  exit 2
fi
if [ $# -gt 0 ] && [ ! -r "$1" ]; then
  echo "$1 cannot be read" >&2
  exit 1
fi

sh "$root/cmake/install_packages.sh" g++ make cmake libexpat1-dev libminizip-dev libboost-iostreams-dev libcgal-dev libcli11-dev \
  libeigen3-dev libjs-three libmeshoptimizer-dev libpng-dev libtbb-dev nlohmann-json3-dev zlib1g-dev
if [ ! -e "$root/build/bin/segment_mesh" ]; then
  # -O1 takes two thirds of the time of Release's -O3.
  configured=$(cmake -S "$root" -B "$root/build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" \
    -DREGION_SEGMENTATION_BUILD_PROGRAM=ON -DREGION_SEGMENTATION_BUILD_TESTS=OFF)
  if missing=$(printf '%s\n' "$configured" | grep "segment_mesh is not built"); then
    echo "${missing#-- }" >&2
    exit 1
  fi
  echo "The program segment_mesh is compiled now, once, in some two minutes of one core (75 seconds of two)." >&2
fi
cmake --build "$root/build" -j 2 --target segment_mesh

"$root/build/bin/segment_mesh" "${1:---demo}" ${2:+-k "$2"} -o "{stem}_segments.ply" -o "{stem}.html"
