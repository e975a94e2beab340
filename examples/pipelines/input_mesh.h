// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_PIPELINES_INPUT_MESH_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_PIPELINES_INPUT_MESH_H

#include "../bushing.h"
#include "../dumbbell.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>

#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

/// The file that the command line names, in triangles; or the mesh of the examples.
inline Mesh input_mesh(int argc, char** argv)
{
  if (argc < 2)
    return make_dumbbell<Mesh, Point>();
  Mesh mesh;
  if (!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << argv[1] << ": not a mesh\n";
    std::exit(EXIT_FAILURE);
  }
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  return mesh;
}

/// The same; or the machine part of the examples.
inline Mesh input_part(int argc, char** argv)
{
  return argc < 2 ? make_bushing<Mesh, Point>() : input_mesh(argc, argv);
}

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_PIPELINES_INPUT_MESH_H
