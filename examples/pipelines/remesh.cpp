// SPDX-License-Identifier: GPL-3.0-or-later
//
// Remeshing that keeps the borders between segments, and carries the labels over to the new faces.

#include "input_mesh.h"

#include <CGAL/Region_segmentation/Segments/segment_borders.h>
#include <CGAL/region_segmentation.h>

#include <CGAL/Polygon_mesh_processing/remesh.h>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = input_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  auto is_border = mesh.add_property_map<Mesh::Edge_index, bool>("e:border", false).first;
  RS::segment(mesh, segment_id, RS::parameters::number_of_segments(6));
  const std::size_t before = RS::mark_segment_borders(mesh, segment_id, is_border);

  double length = 0; // protected edges are at most 4/3 of the length aimed at
  for (auto e : edges(mesh))
    if (is_border[e] || mesh.is_border(e))
      length = (std::max)(length, CGAL::to_double(PMP::edge_length(e, mesh)));
  if (length == 0)
    length = CGAL::to_double(PMP::edge_length(*edges(mesh).begin(), mesh));
  for (auto e : edges(mesh)) // those of the mesh, too
    is_border[e] = is_border[e] || mesh.is_border(e);
  PMP::isotropic_remeshing(faces(mesh), length, mesh,
                           CGAL::parameters::edge_is_constrained_map(is_border)
                             .face_patch_map(segment_id)
                             .protect_constraints(true)
                             .number_of_iterations(3));
  mesh.collect_garbage();

  const std::size_t after = RS::mark_segment_borders(mesh, segment_id, is_border);
  std::cout << num_faces(mesh) << " faces, " << after << " edges between segments, " << before
            << " before\n";
  return after == before ? EXIT_SUCCESS : EXIT_FAILURE;
}
