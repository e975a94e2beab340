// SPDX-License-Identifier: GPL-3.0-or-later
//
// The borders of segments are the cuts of a parameterization: each segment becomes a mesh of its
// own, and is flattened if it is a disc. The file has the flat ones side by side.

#include "../example_mesh.h"

#include <CGAL/Region_segmentation/Segments/compute_segment_topology.h>
#include <CGAL/Region_segmentation/Segments/split_into_segments.h>
#include <CGAL/region_segmentation.h>

#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace RS = CGAL::Region_segmentation;
namespace SMP = CGAL::Surface_mesh_parameterization;

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv), flat;
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  RS::segment(mesh, segment_id);

  std::vector<RS::Segment_topology<std::size_t>> topologies;
  RS::compute_segment_topology(mesh, segment_id, std::back_inserter(topologies));
  std::vector<RS::Segment_piece<Mesh, Mesh, std::size_t>> pieces; // in the same order
  RS::split_into_segments(mesh, segment_id, std::back_inserter(pieces));
  auto disc_id = flat.add_property_map<Mesh::Face_index, std::size_t>("f:disc").first;
  std::size_t number_of_discs = 0, number_of_flat_ones = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!topologies[i].is_disc())
      continue;
    ++number_of_discs;
    Mesh& disc = pieces[i].mesh;
    auto uv = disc.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
    const auto all = halfedges(disc);
    const auto border = *std::find_if(all.begin(), all.end(),
                                      [&](auto h) { return disc.is_border(h); });
    if (SMP::parameterize(disc, SMP::LSCM_parameterizer_3<Mesh>(), border, uv) != SMP::OK)
      continue;
    for (auto v : vertices(disc))
      disc.point(v) = Point(uv[v].x() + 2.0 * double(number_of_flat_ones), uv[v].y(), 0);
    disc.add_property_map<Mesh::Face_index, std::size_t>("f:disc", pieces[i].segment);
    flat += disc; // with the numbers
    ++number_of_flat_ones;
  }
  std::cout << number_of_discs << " discs, " << number_of_flat_ones << " flattened\n";
  for (const auto& topology : topologies)
    if (!topology.is_disc()) // more cuts would open it: edge_is_constrained_map of the pieces
      std::cout << "segment " << topology.segment << " is no disc: it has "
                << topology.number_of_border_loops << " borders and genus " << topology.genus()
                << '\n';
  write_colored(flat, disc_id, "parameterize.ply");
}
