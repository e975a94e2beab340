// SPDX-License-Identifier: GPL-3.0-or-later
//
// From CGAL's SDF segmentation to this package: the maps are the same; its labels can be used
// further here, and its values could be a scalar in a cost (see scalar.cpp).

#include "input_mesh.h"

#include <CGAL/Region_segmentation/Segments/segment_borders.h>
#include <CGAL/Region_segmentation/evaluation.h>
#include <CGAL/Region_segmentation/smooth_borders.h>
#include <CGAL/region_segmentation.h>

#include <CGAL/mesh_segmentation.h>

namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = input_mesh(argc, argv);
  auto sdf = mesh.add_property_map<Mesh::Face_index, double>("f:sdf").first;
  auto by_sdf = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:by_sdf").first;
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  auto is_border = mesh.add_property_map<Mesh::Edge_index, bool>("e:border").first;

  // Before.
  CGAL::sdf_values(mesh, sdf);
  const std::size_t n_by_sdf = CGAL::segmentation_from_sdf_values(mesh, sdf, by_sdf);

  // After.
  const std::size_t n = RS::segment(mesh, segment_id);
  std::cout << n_by_sdf << " segments by SDF, " << n << " here; Rand index distance "
            << RS::rand_index_distance(mesh, by_sdf, segment_id) << '\n';

  // What comes after a segmentation takes the labels of either.
  const std::size_t before = RS::mark_segment_borders(mesh, by_sdf, is_border);
  const std::size_t moved = RS::smooth_borders(mesh, by_sdf);
  const std::size_t after = RS::mark_segment_borders(mesh, by_sdf, is_border);
  std::cout << moved << " faces moved; " << before << " edges between segments, then " << after
            << '\n';
  return n_by_sdf > 0 && n > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
