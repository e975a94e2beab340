// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_POLYGON_SOUP_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_POLYGON_SOUP_H

#include "soup/Polygons.h"

#include <array>
#include <cstddef>
#include <vector>

namespace segment_mesh {

/// Coordinates. \cgal's kernels take longer to compile than most parts of the program, so only
/// those that compute with points know one.
using Point = std::array<double, 3>;

/// An edge by the indices of its points.
using Vertex_pair = std::array<std::size_t, 2>;

/// Points, and faces as cycles of indices of points.
struct Polygon_soup
{
  using Polygon = Polygons::Polygon;

  std::vector<Point> points;
  Polygons polygons;
};

/// The mean of the corners.
inline Point centroid(const Polygon_soup& soup, const Polygon_soup::Polygon& polygon)
{
  Point mean = {0, 0, 0};
  for (std::size_t i : polygon)
    for (std::size_t j = 0; j < 3; ++j)
      mean[j] += soup.points[i][j] / double(polygon.size());
  return mean;
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_POLYGON_SOUP_H
