#!/bin/sh
# compile_alone.sh DIR CLANG OPTION...: each example compiles alone, in the layout of CGAL's repository, made in DIR.
#
# What nearly all include is precompiled, and so is each example: as a header, of which clang instantiates nothing that it need
# not (2 in place of 8 s).
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
dir=$1
shift
rm -rf "$dir"
sh "$root/cmake/make_cgal_layout.sh" "$dir"
cat >"$dir/common.h" <<'END'
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/region_segmentation.h>
END
"$@" -x c++-header "$dir/common.h" -o "$dir/common.pch"
for example in "$dir"/Region_segmentation/examples/Region_segmentation/*.cpp; do
  "$@" -include-pch "$dir/common.pch" -x c++-header "$example" -o /dev/null
done
