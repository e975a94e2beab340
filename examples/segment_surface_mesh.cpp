// SPDX-License-Identifier: GPL-3.0-or-later
//
// The first step: a mesh in as many segments as the method chooses, each in a color.

#include <CGAL/region_segmentation.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char** argv)
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : CGAL::data_file_path("figure.off"), mesh)) {
    std::cerr << "The mesh cannot be read.\n";
    return EXIT_FAILURE;
  }
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  std::cout << CGAL::Region_segmentation::segment(mesh, segment_id) << " segments\n";

  auto color = mesh.add_property_map<Mesh::Face_index, CGAL::IO::Color>("f:color").first;
  for (auto f : faces(mesh))
    color[f].set_hsv(double(segment_id[f] * 137 % 360), 60, 95);
  std::ofstream out("segment_surface_mesh.ply");
  CGAL::IO::write_PLY(out, mesh);
  return EXIT_SUCCESS;
}
