// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each segment becomes a solid, as for printing: they fit together, and their volumes add up.

#include "../example_mesh.h"

#include <CGAL/Region_segmentation/Segments/close_segments.h>
#include <CGAL/region_segmentation.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <iterator>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv), exploded;
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  RS::segment(mesh, segment_id);
  std::vector<RS::Segment_piece<Mesh, Mesh, std::size_t>> solids;
  RS::close_segments(mesh, segment_id, std::back_inserter(solids));

  auto solid_id = exploded.add_property_map<Mesh::Face_index, std::size_t>("f:solid").first;
  double sum = 0;
  for (auto& solid : solids) {
    sum += CGAL::to_double(PMP::volume(solid.mesh));
    const auto shift = 0.3 * (PMP::centroid(solid.mesh) - PMP::centroid(mesh));
    for (auto v : vertices(solid.mesh)) // apart from the others, to be seen
      solid.mesh.point(v) = solid.mesh.point(v) + shift;
    solid.mesh.add_property_map<Mesh::Face_index, std::size_t>("f:solid", solid.segment);
    exploded += solid.mesh; // with the numbers
  }
  std::cout << solids.size() << " solids; volume " << PMP::volume(mesh) << ", sum of theirs " << sum
            << '\n';
  write_colored(exploded, solid_id, "split_and_close.ply");
}
