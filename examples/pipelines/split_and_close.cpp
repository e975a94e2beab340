// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each segment becomes a solid, as for printing: they fit together, and their volumes add up.

#include "input_mesh.h"

#include <CGAL/Region_segmentation/Segments/close_segments.h>
#include <CGAL/region_segmentation.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <cmath>
#include <iterator>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = input_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  RS::segment(mesh, segment_id, RS::parameters::number_of_segments(6));
  std::vector<RS::Segment_piece<Mesh, Mesh, std::size_t>> solids;
  RS::close_segments(mesh, segment_id, std::back_inserter(solids));
  bool are_closed = true;
  double sum = 0;
  for (const auto& solid : solids) {
    are_closed = are_closed && CGAL::is_closed(solid.mesh) &&
                 CGAL::is_valid_polygon_mesh(solid.mesh);
    const double volume = CGAL::to_double(PMP::volume(solid.mesh));
    sum += volume;
    std::cout << "segment " << solid.segment << ": volume " << volume
              << (PMP::does_self_intersect(solid.mesh) ? ", intersects itself\n" : "\n");
  }
  if (!CGAL::is_closed(mesh))
    return are_closed ? EXIT_SUCCESS : EXIT_FAILURE; // it has no volume
  const double volume = CGAL::to_double(PMP::volume(mesh));
  return are_closed && std::abs(sum - volume) <= 1e-9 * volume ? EXIT_SUCCESS : EXIT_FAILURE;
}
