// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_CORNER_NORMALS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_CORNER_NORMALS_H

#include "soup/vector_algebra.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace segment_mesh {

/// The normals at the corners of faces, which are ranges of indices of points: the surface looks
/// smooth, but for edges that are sharp.
template <typename Faces>
class Corner_normals
{
public:
  Corner_normals(const std::vector<Point>& points, const Faces& faces)
    : m_faces_of_point(points.size())
  {
    for (const auto& face : faces) {
      for (std::size_t point : face)
        m_faces_of_point[point].push_back(m_area_vectors.size());
      m_area_vectors.push_back(area_vector(points, face));
    }
  }

  /// A unit vector, or zero: the mean, by area, of the normals round the point that are near that
  /// of the face, turned to its side, should they be turned the wrong way.
  Point at(std::size_t face, std::size_t point) const
  {
    constexpr std::size_t many = 64;         // a fan of n faces would take n * n steps
    constexpr double cosine_of_sharp = 0.77; // 40 degrees
    const Point normal = unit_vector(m_area_vectors[face]);
    if (m_faces_of_point[point].size() > many)
      return normal;
    Point sum = {0, 0, 0};
    for (std::size_t other : m_faces_of_point[point]) {
      const Point& vector = m_area_vectors[other];
      const double along = inner_product(normal, vector);
      if (std::abs(along) > cosine_of_sharp * length(vector))
        sum = plus(sum, times(along < 0 ? -1 : 1, vector));
    }
    return unit_vector(sum);
  }

private:
  std::vector<Point> m_area_vectors;
  std::vector<std::vector<std::size_t>> m_faces_of_point;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_CORNER_NORMALS_H
