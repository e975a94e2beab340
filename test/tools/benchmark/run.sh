#!/bin/sh
# run.sh [OPTION...]: measures speed and memory, and prints the tables of doc/performance.md; writes speed.csv where it is
# called. Takes an hour; `--sizes 160000` minutes. The options are those of speed_benchmark (--help).
set -eu
root=$(cd "$(dirname "$0")/../../.." && pwd)
sh "$root/cmake/install_packages.sh" g++ make cmake python3 libcgal-dev libcgal-demo libeigen3-dev libcli11-dev libtbb-dev \
  libmetis-dev libmeshoptimizer-dev
build=$root/build-tools
meshes=$build/real_meshes
if [ ! -d "$meshes" ]; then
  mkdir -p "$meshes.part"
  tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C "$meshes.part"
  mv "$meshes.part" "$meshes"
fi
sh "$root/test/tools/build.sh" "$build" speed_benchmark
"$build/bin/speed_benchmark" --meshes "$meshes" "$@" > speed.csv
python3 "$root/test/tools/tables.py" speed.csv
