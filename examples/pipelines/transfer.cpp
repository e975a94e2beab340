// SPDX-License-Identifier: GPL-3.0-or-later
//
// A remeshed copy is segmented, and its labels are given to the faces of the original; and back.

#include "input_mesh.h"

#include <CGAL/Region_segmentation/Segments/transfer_labels.h>
#include <CGAL/region_segmentation.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = input_mesh(argc, argv), copy = mesh;
  double length = 0;
  for (auto e : edges(mesh))
    length += CGAL::to_double(PMP::edge_length(e, mesh)) / double(num_edges(mesh));
  PMP::isotropic_remeshing(faces(copy), length, copy);
  copy.collect_garbage();

  auto of_copy = copy.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  auto of_mesh = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  auto back = copy.add_property_map<Mesh::Face_index, std::size_t>("f:back").first;
  const std::size_t n = RS::segment(copy, of_copy, RS::parameters::number_of_segments(6));
  const std::size_t there = RS::transfer_labels(copy, of_copy, mesh, of_mesh);
  RS::transfer_labels(mesh, of_mesh, copy, back);

  const double area = CGAL::to_double(PMP::area(copy));
  double kept = 0;
  for (auto f : faces(copy))
    if (of_copy[f] == back[f])
      kept += CGAL::to_double(PMP::face_area(f, copy)) / area;
  std::cout << n << " segments, " << there << " on the original; " << kept
            << " of the area has its label there and back\n";
  return n == there && kept > 0.95 ? EXIT_SUCCESS : EXIT_FAILURE;
}
