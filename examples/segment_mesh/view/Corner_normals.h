// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_CORNER_NORMALS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_CORNER_NORMALS_H

#include "soup/vector_algebra.h"

#include <algorithm>
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
    : m_points(points)
    , m_faces(faces)
    , m_faces_of_point(points.size())
  {
    for (const auto& face : faces) {
      for (std::size_t point : face)
        m_faces_of_point[point].push_back(m_area_vectors.size());
      m_area_vectors.push_back(area_vector(points, face));
    }
  }

  /// A unit vector, or zero: the mean, by area, of the normals round the point that are near that
  /// of the face. The normal of a sliver may be arbitrary: unless another face has it, too, that of
  /// the largest face at the point takes its place.
  Point at(std::size_t face, std::size_t point) const
  {
    constexpr std::size_t many = 64; // a fan of n faces would take n * n steps
    constexpr double thin = 0.02, small = 0.1;
    const Point& own = m_area_vectors[face];
    if (m_faces_of_point[point].size() > many)
      return unit_vector(own);
    Point sum = sum_near(own, point);
    const double side = longest_side(face, point), area = length(own);
    if (area < thin * side * side && length(sum) < 2 * area) {
      const Point& largest = largest_area_vector(point);
      if (area < small * length(largest))
        sum = sum_near(largest, point);
    }
    return unit_vector(sum);
  }

private:
  /// The sum of the area vectors round a point that are near a direction, turned to its side,
  /// should they be turned the wrong way.
  Point sum_near(const Point& direction, std::size_t point) const
  {
    constexpr double cosine_of_sharp = 0.77; // 40 degrees
    const Point normal = unit_vector(direction);
    Point sum = {0, 0, 0};
    for (std::size_t face : m_faces_of_point[point]) {
      const Point& vector = m_area_vectors[face];
      const double along = inner_product(normal, vector);
      if (std::abs(along) > cosine_of_sharp * length(vector))
        sum = plus(sum, times(along < 0 ? -1 : 1, vector));
    }
    return sum;
  }

  const Point& largest_area_vector(std::size_t point) const
  {
    const std::vector<std::size_t>& faces = m_faces_of_point[point];
    return m_area_vectors[*std::max_element(
      faces.begin(), faces.end(), [this](std::size_t f, std::size_t g) {
        return length(m_area_vectors[f]) < length(m_area_vectors[g]);
      })];
  }

  /// Of those of a face that leave one of its points.
  double longest_side(std::size_t face, std::size_t point) const
  {
    double longest = 0;
    for (std::size_t other : m_faces[face])
      longest = (std::max)(longest, length(minus(m_points[other], m_points[point])));
    return longest;
  }

  const std::vector<Point>& m_points;
  const Faces& m_faces;
  std::vector<Point> m_area_vectors;
  std::vector<std::vector<std::size_t>> m_faces_of_point;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_CORNER_NORMALS_H
