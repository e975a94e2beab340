// SPDX-License-Identifier: GPL-3.0-or-later
//
// A visitor sees the stages and can end the run; the output is as before then.

#include "dumbbell.h"

#include <CGAL/region_segmentation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cstring>
#include <iostream>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace RS = CGAL::Region_segmentation;

/// A model of `SegmentationVisitor` that gives up half way through the merging.
struct Impatient_visitor
{
  bool go_further(const char* stage, double fraction)
  {
    std::cout << stage << ": " << 100 * fraction << " %\n";
    return std::strcmp(stage, "draws") != 0 || fraction < 0.5;
  }
};

int main()
{
  Mesh mesh = make_dumbbell<Mesh, Point>();
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  Impatient_visitor visitor;
  try {
    RS::segment(mesh, segment_id, RS::parameters::number_of_segments(1).visitor(std::ref(visitor)));
  } catch (const RS::Segmentation_cancelled& e) {
    std::cout << e.what() << '\n';
    return 0;
  }
  return 1;
}
