#!/bin/sh
# make_figures.sh [BUILD]: makes the figures of the manual and the README anew, with the program in BUILD
# (default: build/, where examples/run.sh puts it).
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
program=${1:-$root/build}/bin/segment_mesh
"$program" --quiet -o "$root/doc/Region_segmentation/fig/{stem}.png"
