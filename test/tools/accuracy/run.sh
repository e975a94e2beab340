#!/bin/sh
# run.sh PRINCETON FURNITURE: measures accuracy on a copy of the Princeton Segmentation Benchmark and on a folder of
# furniture, and prints the tables of doc/accuracy.md. Takes an hour of two cores; writes its CSV where it is called.
set -eu
root=$(cd "$(dirname "$0")/../../.." && pwd)
sh "$root/cmake/install_packages.sh" g++ make cmake python3 libcgal-dev libeigen3-dev libcli11-dev libtbb-dev \
  libmetis-dev libmeshoptimizer-dev
sh "$root/test/tools/build.sh" "$root/build-tools" princeton_benchmark label_stability train_merge_cost
bin=$root/build-tools/bin
"$bin/train_merge_cost" --data "$1" --furniture "$2" --scores --draws 1,3,7,9 > training.csv &
"$bin/princeton_benchmark" --data "$1" --furniture "$2" --runs 3 > methods.csv
"$bin/princeton_benchmark" --data "$1" --methods concave-angles,sdf > others.csv
"$bin/princeton_benchmark" --data "$1" --furniture "$2" --methods visibility --draws 1 > one_draw.csv
"$bin/label_stability" --data "$1" --every 5 > copies.csv
"$bin/label_stability" --data "$1" --every 5 --draws 1 | tail -n +2 >> copies.csv
wait
python3 "$root/test/tools/tables.py" methods.csv others.csv one_draw.csv training.csv copies.csv
