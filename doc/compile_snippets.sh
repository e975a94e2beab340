#!/bin/sh
# compile_snippets.sh COMPILER OPTION...: the program of the README compiles, and after it the blocks of C++ of the user's
# manual, in a function that has what they name.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The blocks between lines of a file that match BEGIN and END, each in braces.
blocks() { # FILE BEGIN END
  awk -v begin="$2" -v end="$3" '
    inside && $0 ~ end { inside = 0; print "}" }
    inside { print; ++lines }
    $0 ~ begin { inside = 1; print "{" }
    END { exit lines == 0 }' "$1"
}

blocks "$root/doc/Region_segmentation/Region_segmentation.txt" '^.code[{][.]cpp[}]' '^.endcode' >"$work/manual"
blocks "$root/README.md" '^```cpp' '^```$' | sed '1d; $d' >"$work/snippets.cpp"
cat >>"$work/snippets.cpp" <<END
#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>
$(grep '^#include' "$work/manual")

namespace RS = CGAL::Region_segmentation;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

void manual(Mesh& mesh, Mesh::Property_map<Mesh::Face_index, std::size_t> segment_id)
{
  const auto vpm = get(CGAL::vertex_point, mesh);
$(grep -v '^#include' "$work/manual")
}
END
"$@" -fsyntax-only "$work/snippets.cpp"
