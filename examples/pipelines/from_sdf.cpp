// SPDX-License-Identifier: GPL-3.0-or-later
//
// From CGAL's SDF segmentation to this package: the maps are the same, and what comes after a
// segmentation takes the labels of either.

#include "../example_mesh.h"

#include <CGAL/Region_segmentation/Evaluation/evaluation.h>
#include <CGAL/Region_segmentation/Superfacets/smooth_borders.h>
#include <CGAL/region_segmentation.h>

#include <CGAL/mesh_segmentation.h>

namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv);
  auto sdf = mesh.add_property_map<Mesh::Face_index, double>("f:sdf").first;
  auto by_sdf = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:by_sdf").first;
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;

  // Before.
  CGAL::sdf_values(mesh, sdf);
  std::cout << CGAL::segmentation_from_sdf_values(mesh, sdf, by_sdf) << " segments by SDF\n";

  // After.
  std::cout << RS::segment(mesh, segment_id) << " segments here, Rand index distance "
            << RS::rand_index_distance(mesh, by_sdf, segment_id) << '\n';

  std::cout << RS::smooth_borders(mesh, by_sdf) << " faces are moved by straight borders\n";
  write_colored(mesh, by_sdf, "from_sdf.ply");
}
