// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments are cut open along seams, each to a mesh of its own that is a disc, and flattened. The
// file has the discs side by side.

#include "../example_mesh.h"

#include <CGAL/Region_segmentation/Segments/mark_segment_seams.h>
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
  auto is_seam = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam").first;
  RS::segment(mesh, segment_id);
  RS::mark_segment_seams(mesh, segment_id, is_seam);

  std::vector<RS::Segment_piece<Mesh, Mesh, std::size_t>> discs;
  RS::split_into_segments(mesh, segment_id, std::back_inserter(discs),
                          RS::parameters::edge_is_constrained_map(is_seam));
  auto disc_id = flat.add_property_map<Mesh::Face_index, std::size_t>("f:disc").first;
  std::size_t number_of_flat_ones = 0;
  for (auto& piece : discs) {
    Mesh& disc = piece.mesh;
    auto uv = disc.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
    const auto all = halfedges(disc);
    const auto border = *std::find_if(all.begin(), all.end(),
                                      [&](auto h) { return disc.is_border(h); });
    if (SMP::parameterize(disc, SMP::LSCM_parameterizer_3<Mesh>(), border, uv) != SMP::OK)
      continue;
    for (auto v : vertices(disc))
      disc.point(v) = Point(uv[v].x() + 2.0 * double(number_of_flat_ones), uv[v].y(), 0);
    disc.add_property_map<Mesh::Face_index, std::size_t>("f:disc", piece.segment);
    flat += disc; // with the numbers
    ++number_of_flat_ones;
  }
  std::cout << discs.size() << " discs, " << number_of_flat_ones << " flattened\n";
  write_colored(flat, disc_id, "parameterize.ply");
}
