// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments, which the default method makes connected, are cut open along seams, each to a mesh of
// its own that is a disc, and flattened.

#include "input_mesh.h"

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
  Mesh mesh = input_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  auto is_seam = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam").first;
  RS::segment(mesh, segment_id);
  RS::mark_segment_seams(mesh, segment_id, is_seam);

  std::vector<RS::Segment_piece<Mesh, Mesh, std::size_t>> discs;
  RS::split_into_segments(mesh, segment_id, std::back_inserter(discs),
                          RS::parameters::edge_is_constrained_map(is_seam));
  std::size_t failures = 0;
  for (auto& disc : discs) {
    auto uv = disc.mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
    const auto all = halfedges(disc.mesh);
    const auto border = *std::find_if(all.begin(), all.end(),
                                      [&](auto h) { return disc.mesh.is_border(h); });
    failures += SMP::parameterize(disc.mesh, SMP::LSCM_parameterizer_3<Mesh>(), border, uv) !=
                SMP::OK;
  }
  std::cout << discs.size() << " discs, " << failures << " are not flattened\n";
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
