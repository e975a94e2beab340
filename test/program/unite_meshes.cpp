// SPDX-License-Identifier: GPL-3.0-or-later

// unite_meshes UNION.off MESH.off...: the union of closed meshes, by CGAL's corefinement.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main(int argc, char** argv)
{
  Mesh all;
  for (int i = 2; i < argc; ++i) {
    Mesh mesh;
    if (!PMP::IO::read_polygon_mesh(argv[i], mesh) ||
        !PMP::corefine_and_compute_union(all, mesh, all))
      return EXIT_FAILURE;
  }
  return CGAL::IO::write_polygon_mesh(argv[1], all, CGAL::parameters::stream_precision(17))
           ? EXIT_SUCCESS
           : EXIT_FAILURE;
}
