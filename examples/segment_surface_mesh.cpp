// SPDX-License-Identifier: GPL-3.0-or-later
//
// segment_surface_mesh [FILE [K]]: segments a mesh into K parts and says how large they are.

#include "dumbbell.h"

#include <CGAL/region_segmentation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <vector>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace RS = CGAL::Region_segmentation;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if (argc < 2)
    mesh = make_dumbbell<Mesh, Point>();
  else if (!CGAL::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "cannot read " << argv[1] << '\n';
    return EXIT_FAILURE;
  }
  const std::size_t k = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 3;

  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  const std::size_t n = RS::segment(mesh, segment_id, RS::parameters::number_of_segments(k));

  std::vector<std::size_t> sizes(n);
  for (auto f : faces(mesh))
    ++sizes[segment_id[f]];
  for (std::size_t i = 0; i < n; ++i)
    std::cout << "segment " << i << ": " << sizes[i] << " faces\n";
}
