// SPDX-License-Identifier: GPL-3.0-or-later
//
// A remeshed copy is segmented, and its labels are given to the faces of the original.

#include "../example_mesh.h"

#include <CGAL/Region_segmentation/Segments/transfer_labels.h>
#include <CGAL/region_segmentation.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <cmath>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv), copy = mesh;
  PMP::isotropic_remeshing(faces(copy), std::sqrt(CGAL::to_double(PMP::area(copy))) / 60, copy);
  copy.collect_garbage();

  auto of_copy = copy.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  auto of_mesh = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  const std::size_t n = RS::segment(copy, of_copy);
  std::cout << num_faces(copy) << " faces in " << n << " segments; on the original there are "
            << RS::transfer_labels(copy, of_copy, mesh, of_mesh) << '\n';
  write_colored(mesh, of_mesh, "transfer.ply");
}
