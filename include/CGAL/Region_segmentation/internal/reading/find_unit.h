// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_FIND_UNIT_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_FIND_UNIT_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/internal/reading/Mesh_traversal.h>
#include <CGAL/Region_segmentation/internal/reading/Vertex_points.h>
#include <CGAL/Region_segmentation/internal/support/blocks.h>
#include <CGAL/Region_segmentation/internal/support/unit_of_coordinates.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Properties of the points of a block of vertices.
struct Extent
{
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  double largest_coordinate = 0; // of the vertices that are used
  std::size_t not_finite = none; // the first such vertex
};

template <typename FaceGraph, typename Pack>
Extent extent_of_block(const Mesh_traversal<FaceGraph, Pack>& traversal, const Vertex_points<FaceGraph, Pack>& points,
                       std::size_t block, std::size_t rank)
{
  Extent extent;
  for (auto v : traversal.vertices_of_block(block)) {
    const Double_3 p = points(v);
    const double x = std::abs(p.x), y = std::abs(p.y), z = std::abs(p.z);
    // Rarely taken; also taken for NaN.
    if (!(x <= extent.largest_coordinate && y <= extent.largest_coordinate && z <= extent.largest_coordinate)) {
      if (!is_finite(p))
        extent.not_finite = (std::min)(extent.not_finite, rank);
      else if (halfedge(v, traversal.mesh()) != boost::graph_traits<FaceGraph>::null_halfedge())
        extent.largest_coordinate = (std::max)({extent.largest_coordinate, x, y, z});
    }
    ++rank;
  }
  return extent;
}

/// The largest coordinate of the vertices of faces.
/// \throws Invalid_input if a point is not finite
template <typename ConcurrencyTag, typename FaceGraph, typename Pack>
double find_largest_coordinate(const Mesh_traversal<FaceGraph, Pack>& traversal, const Pack& np)
{
  const Vertex_points<FaceGraph, Pack> points(traversal.mesh(), np, 1);
  const std::size_t size = traversal.number_of_vertices();
  std::vector<Extent> extents(number_of_blocks(size));
  for_each_block(Execution<ConcurrencyTag>(), size, [&](std::size_t block, std::size_t rank, std::size_t) {
    extents[block] = extent_of_block(traversal, points, block, rank);
  });
  double largest_coordinate = 0;
  for (const Extent& extent : extents) {
    if (extent.not_finite != Extent::none)
      throw Invalid_input("the point of vertex " + std::to_string(extent.not_finite) + " is not finite");
    largest_coordinate = (std::max)(largest_coordinate, extent.largest_coordinate);
  }
  return largest_coordinate;
}

/// The unit of length for the points of a mesh.
/// \throws Invalid_input if a point is not finite
template <typename ConcurrencyTag, typename FaceGraph, typename Pack>
double find_unit(const Mesh_traversal<FaceGraph, Pack>& traversal, const Pack& np)
{
  return unit_of_coordinates(find_largest_coordinate<ConcurrencyTag>(traversal, np));
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_FIND_UNIT_H
