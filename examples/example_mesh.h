// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_EXAMPLE_MESH_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_EXAMPLE_MESH_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

/// The file that the command line names, in triangles; without one, `file` of the folder data.
inline Mesh read_mesh(int argc, char** argv, const std::string& file = "figure.off")
{
  const std::string name = argc > 1 ? argv[1] : CGAL::data_file_path(file);
  Mesh mesh;
  if (!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(name, mesh)) {
    std::cerr << name << " cannot be read as a mesh\n";
    std::exit(EXIT_FAILURE);
  }
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  return mesh;
}

/// Writes a PLY file in which each number has a color of its own.
template <typename Face_number_map>
void write_colored(Mesh mesh, const Face_number_map& number, const std::string& file)
{
  auto color = mesh.add_property_map<Mesh::Face_index, CGAL::IO::Color>("f:color").first;
  for (auto f : faces(mesh))
    color[f].set_hsv(double(get(number, f) * 137 % 360), 60, 95); // the golden angle apart
  std::ofstream out(file);
  CGAL::IO::write_PLY(out, mesh);
}

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_EXAMPLE_MESH_H
