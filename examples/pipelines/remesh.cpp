// SPDX-License-Identifier: GPL-3.0-or-later
//
// Remeshing that keeps the borders between segments, and carries the labels over to the new faces.

#include "../example_mesh.h"

#include <CGAL/region_segmentation.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <cmath>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  const std::size_t n = RS::segment(mesh, segment_id);
  PMP::isotropic_remeshing(faces(mesh), std::sqrt(CGAL::to_double(PMP::area(mesh))) / 60, mesh,
                           CGAL::parameters::face_patch_map(segment_id));
  mesh.collect_garbage();
  std::cout << n << " segments, " << num_faces(mesh) << " faces\n";
  write_colored(mesh, segment_id, "remesh.ply");
}
