// SPDX-License-Identifier: GPL-3.0-or-later
//
// Remeshing of a machine part that keeps its faces: their borders are constraints.

#include "input_mesh.h"

#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/Region_segmentation/Segments/segment_borders.h>
#include <CGAL/Region_segmentation/segment.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = input_part(argc, argv);
  auto face_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:face").first;
  auto is_border = mesh.add_property_map<Mesh::Edge_index, bool>("e:border", false).first;
  RS::segment(mesh, face_id, RS::parameters::method(RS::Smooth_faces()));
  RS::mark_segment_borders(mesh, face_id, is_border);
  const auto border_length = [&] {
    double length = 0;
    for (const auto e : mesh.edges())
      length += is_border[e] ? CGAL::to_double(PMP::edge_length(e, mesh)) : 0;
    return length;
  };
  const double before = border_length(), target = std::sqrt(CGAL::to_double(PMP::area(mesh))) / 30;
  const auto np = CGAL::parameters::edge_is_constrained_map(is_border);
  PMP::split_long_edges(mesh.edges(), target, mesh, np);
  PMP::isotropic_remeshing(mesh.faces(), target, mesh, np.protect_constraints(true));
  mesh.collect_garbage();
  PMP::connected_components(mesh, face_id, np);
  std::cout << mesh.number_of_faces() << " triangles, length of borders " << border_length() << ", "
            << before << " before\n";
  return std::fabs(border_length() - before) < 1e-6 * before ? EXIT_SUCCESS : EXIT_FAILURE;
}
