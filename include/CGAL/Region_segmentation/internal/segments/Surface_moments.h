// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SURFACE_MOMENTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SURFACE_MOMENTS_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/support/Second_moments.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// 1, or -1 for a face of a component that was turned, see `Flat_mesh`: there the normals are, but not the corners.
inline double orientation_of_corners(const Flat_mesh& mesh, std::size_t face)
{
  const Mesh_points& points = mesh.points();
  const Double_3 origin = points[points.corner(face, 0)];
  Double_3 area_vector{0, 0, 0};
  for (std::size_t i = 2; i < points.number_of_corners(face); ++i)
    area_vector = area_vector + cross(points[points.corner(face, i - 1)] - origin, points[points.corner(face, i)] - origin);
  return dot(area_vector, mesh.normal(face)) < 0 ? -1 : 1;
}

/// Integrals over a surface of polygons, relative to a point near it, so that nothing cancels far from the origin.
class Surface_moments
{
public:
  explicit Surface_moments(const Double_3& origin = {0, 0, 0}) : m_origin(origin) {}

  /// Adds a face. A triangle of its fan counts with its area as seen along the normal, so a face may be concave; a
  /// degenerate one counts nothing.
  void add_face(const Flat_mesh& mesh, std::size_t face)
  {
    const Mesh_points& points = mesh.points();
    const double orientation = orientation_of_corners(mesh, face);
    const Double_3 a = points[points.corner(face, 0)] - m_origin;
    Double_3 b = points[points.corner(face, 1)] - m_origin;
    for (std::size_t i = 2; i < points.number_of_corners(face); ++i) {
      const Double_3 c = points[points.corner(face, i)] - m_origin;
      add_triangle(a, b, c, orientation * dot(cross(b - a, c - a), mesh.normal(face)) / 2);
      m_volume += orientation * dot(a, cross(b, c)) / 6;
      b = c;
    }
  }

  /// Adds a triangle to the volume alone, turned around for the orientation -1.
  void add_cap(const Double_3& a, const Double_3& b, const Double_3& c, double orientation)
  {
    m_volume += orientation * dot(a - m_origin, cross(b - m_origin, c - m_origin)) / 6;
  }

  double area() const { return m_moments.weight; }
  double volume() const { return m_volume; } ///< that a closed surface encloses

  /// The origin if there is no area.
  Double_3 centroid() const { return m_origin + m_moments.centroid(); }

  /// The mean of (x - c)(x - c)^T, c the centroid; zero if there is no area.
  Symmetric_3 covariance() const { return m_moments.covariance(); }

private:
  /// The integral of x x^T over a triangle a, b, c of area A is A / 12 (a a^T + b b^T + c c^T + s s^T), s = a + b + c.
  void add_triangle(const Double_3& a, const Double_3& b, const Double_3& c, double area)
  {
    const Double_3 sum = a + b + c;
    m_moments.weight += area;
    m_moments.first = m_moments.first + area / 3 * sum;
    for (const Double_3& v : {a, b, c, sum})
      m_moments.second.add_square(area / 12, v);
  }

  Double_3 m_origin;
  Second_moments m_moments; // relative to the origin
  double m_volume = 0;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SURFACE_MOMENTS_H
