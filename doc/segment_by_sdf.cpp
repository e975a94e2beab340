// SPDX-License-Identifier: GPL-3.0-or-later
//
// segment_by_sdf MESH.off: prints the label of each face by the SDF segmentation of CGAL with its
// defaults, for the figure that shows it beside this package.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/mesh_segmentation.h>

#include <iostream>

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if (argc != 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh))
    return EXIT_FAILURE;
  auto sdf = mesh.add_property_map<Mesh::Face_index, double>("f:sdf").first;
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  CGAL::sdf_values(mesh, sdf);
  CGAL::segmentation_from_sdf_values(mesh, sdf, segment_id);
  for (auto f : faces(mesh))
    std::cout << segment_id[f] << '\n';
}
