// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FACE_TEST_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FACE_TEST_H

#include <CGAL/Region_segmentation/Segments/Fitted_surface.h>
#include <CGAL/Region_segmentation/internal/faces/Face_neighbors.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Whether a face lies on a surface: its vertices do, within a tolerance, and its normal is that of
/// the surface, within some 37 degrees, unless it is thin.
class Face_test
{
public:
  Face_test(const Surface& surface, const Face_neighbors& neighbors, double tolerance)
    : m_surface(surface)
    , m_neighbors(neighbors)
    , m_tolerance(tolerance)
  {}

  double tolerance() const { return m_tolerance; }

  bool operator()(const Fitted_surface<>& s, std::size_t face) const
  {
    return has_vertices_on(s, face) && has_normal_of(s, face);
  }

  bool has_vertices_on(const Fitted_surface<>& s, std::size_t face) const
  {
    const Surface_distance distance(s);
    for (std::size_t i = 0; i < m_surface.number_of_corners(face); ++i)
      if (!(std::fabs(distance(corner(face, i))) <= m_tolerance))
        return false;
    return true;
  }

  bool has_normal_of(const Fitted_surface<>& s, std::size_t face,
                     double cosine = usual_cosine) const
  {
    return m_neighbors.is_thin(face) ||
           dot(m_surface.normal(face), surface_normal(s, m_surface.centroid(face))) > cosine;
  }

  /// The mean distance of the midpoints of the edges of a face to a surface: how much the face
  /// deviates from it.
  double deviation(const Fitted_surface<>& s, std::size_t face) const
  {
    const Surface_distance distance(s);
    const std::size_t n = m_surface.number_of_corners(face);
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i)
      sum += std::fabs(distance(0.5 * (corner(face, i) + corner(face, (i + 1) % n))));
    return sum / double(n);
  }

private:
  static constexpr double usual_cosine = 0.8;

  const Double_3& corner(std::size_t face, std::size_t i) const
  {
    return m_surface.point(m_surface.corner(face, i));
  }

  const Surface& m_surface;
  const Face_neighbors& m_neighbors;
  double m_tolerance;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_FACE_TEST_H
