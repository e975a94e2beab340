// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments, which the default method makes connected, are opened along seams and flattened: as many
// charts as segments.

#include "input_mesh.h"

#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/Region_segmentation/Segments/mark_segment_seams.h>
#include <CGAL/region_segmentation.h>

#include <set>

namespace RS = CGAL::Region_segmentation;
namespace SMP = CGAL::Surface_mesh_parameterization;

int main(int argc, char** argv)
{
  Mesh mesh = input_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  auto is_seam = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam").first;
  auto is_on_seam = mesh.add_property_map<Mesh::Vertex_index, bool>("v:on_seam", false).first;
  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  RS::segment(mesh, segment_id);
  RS::mark_segment_seams(mesh, segment_id, is_seam);
  for (auto e : edges(mesh))
    if (is_seam[e])
      is_on_seam[source(e, mesh)] = is_on_seam[target(e, mesh)] = true;
  using Seam_mesh = CGAL::Seam_mesh<Mesh, decltype(is_seam), decltype(is_on_seam)>;
  Seam_mesh charts(mesh, is_seam, is_on_seam);
  std::set<std::size_t> flattened;
  std::size_t failures = 0;
  for (auto h : halfedges(mesh))
    if (!mesh.is_border(h) && (is_seam[edge(h, mesh)] || mesh.is_border(opposite(h, mesh))) &&
        flattened.insert(segment_id[face(h, mesh)]).second) {
      failures += SMP::parameterize(charts, SMP::LSCM_parameterizer_3<Seam_mesh>(),
                                    opposite(Seam_mesh::halfedge_descriptor(h), charts),
                                    uv) != SMP::OK;
    }
  std::cout << flattened.size() << " charts, " << failures << " are not flattened\n";
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
