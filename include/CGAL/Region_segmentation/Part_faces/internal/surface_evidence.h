// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_SURFACE_EVIDENCE_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_SURFACE_EVIDENCE_H

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Face_grower.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Tessellation.h>
#include <CGAL/Region_segmentation/Part_faces/internal/fit_surface.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The angle of a point around the axis of a cylinder or cone; of a torus, around the circle in its
/// tube; of a sphere, the elevation.
inline double profile_angle(const Fitted_surface<>& s, const Double_3& p)
{
  const Meridian_point m = meridian_point(s, p);
  if (s.kind == Surface_kind::SPHERE)
    return std::atan2(m.z, m.r);
  if (s.kind == Surface_kind::TORUS)
    return std::atan2(m.z, m.r - s.radius);
  const Double_3 u = any_perpendicular(s.direction);
  return std::atan2(dot(m.outward, cross(s.direction, u)), dot(m.outward, u));
}

/// The lines of vertices on a surface that have the same profile angle: rulings of a cylinder or
/// cone, parallels of a torus.
class Profile_lines
{
public:
  /// \param tolerance of the points
  Profile_lines(const Fitted_surface<>& s, const std::vector<Double_3>& points, double tolerance)
    : m_surface(s)
  {
    std::vector<double> angles;
    for (const Double_3& p : points)
      angles.push_back(profile_angle(s, p));
    std::sort(angles.begin(), angles.end());
    double widest = angles.front() + 2 * CGAL_PI - angles.back();
    m_first = angles.front();
    for (std::size_t i = 1; i < angles.size(); ++i)
      if (angles[i] - angles[i - 1] > widest) {
        widest = angles[i] - angles[i - 1];
        m_first = angles[i];
      }
    m_range = 2 * CGAL_PI - widest;
    const double radius = s.kind == Surface_kind::TORUS ? s.minor_radius : s.radius;
    m_same = (std::max)(1e-3 * m_range, radius > 0 ? 4.0 / 3 * tolerance / radius : 0);
    for (double& a : angles)
      a = from_first(a);
    std::sort(angles.begin(), angles.end());
    double line = angles.front();
    for (const double angle : angles)
      if (angle - line > m_same) {
        line = angle;
        ++m_number;
      }
  }

  int number() const { return m_number; }
  /// The mean angle from one to the next.
  double step() const { return m_range / (std::max)(1, m_number - 1); }
  /// 0 or 1 for a point on the first or last one, else 2.
  int end(const Double_3& p) const
  {
    const double a = from_first(profile_angle(m_surface, p));
    return a < m_same ? 0 : a > m_range - m_same ? 1 : 2;
  }

private:
  double from_first(double angle) const
  {
    const double a = angle - m_first;
    return a < -1e-9 ? a + 2 * CGAL_PI : a;
  }

  const Fitted_surface<>& m_surface;
  double m_first, m_range, m_same;
  int m_number = 1;
};

/// The border of the faces that were grown.
struct Grown_border
{
  double length[3] = {0, 0, 0}, tangent[3] = {0, 0, 0}; ///< at the ends and elsewhere
  std::size_t vertices = 0;

  /// The number of ends at which the surface is tangent to most of the faces beside it.
  int number_of_tangent_ends() const
  {
    return (tangent[0] > 0.5 * length[0]) + (tangent[1] > 0.5 * length[1]);
  }
  bool is_tangent() const
  {
    return tangent[0] + tangent[1] + tangent[2] > 0.5 * (length[0] + length[1] + length[2]);
  }
};

/// \param end of a side: 0, 1 or 2
/// \param angle between the normals of the surface and of a face beside it up to which they are
///        tangent
template <typename End>
Grown_border border_of_grown(const Tessellation& mesh, const Face_grower& grower,
                             const Fitted_surface<>& s, const End& end, double angle)
{
  Grown_border result;
  std::vector<Surface::Index> vertices;
  for (const Surface::Index f : grower.faces()) {
    std::size_t i = 0;
    for_each_side(mesh.surface, f, [&](Surface::Index v, Surface::Index w) {
      const Surface::Index other = face_across(mesh.surface, f, i++);
      if (other != Surface::none && grower.is_taken(other))
        return;
      const Double_3 p = mesh.surface.point(v), q = mesh.surface.point(w);
      const int at = end(p), e = at == end(q) ? at : 2;
      const double length = norm(q - p);
      vertices.push_back(v);
      vertices.push_back(w);
      result.length[e] += length;
      if (other != Surface::none && mesh.is_tangent(other, surface_normal(s, 0.5 * (p + q)), angle))
        result.tangent[e] += length;
    });
  }
  std::sort(vertices.begin(), vertices.end());
  result.vertices = std::size_t(std::unique(vertices.begin(), vertices.end()) - vertices.begin());
  return result;
}

/// Whether the surface on which faces lie is more than a coincidence: the number of lines of
/// vertices, and of ends where it is tangent to the faces beside it, as a fillet is, is at least 5,
/// of a sphere 4. There always is a circle through 3 of them, and one through 4 by symmetry. A
/// single row of facets is no evidence of a sphere or torus.
inline bool is_evident(const Tessellation& mesh, const Face_grower& grower,
                       const Fitted_surface<>& s)
{
  constexpr double of_step = 0.15;
  constexpr int fewest_surplus = 3; // points
  const bool is_ruled = s.kind == Surface_kind::CYLINDER || s.kind == Surface_kind::CONE;
  const int fewest = s.kind == Surface_kind::SPHERE ? 4 : 5;
  const Profile_lines lines(s, grower.points(), mesh.tolerance());
  const int surplus = int(grower.points().size()) - degrees_of_freedom(s.kind);
  const Grown_border border = border_of_grown(
    mesh, grower, s, [&](const Double_3& p) { return lines.end(p); }, of_step * lines.step());
  return lines.number() + border.number_of_tangent_ends() >= fewest &&
         surplus + border.number_of_tangent_ends() >= fewest_surplus &&
         (is_ruled || border.vertices < grower.points().size() ||
          (s.kind == Surface_kind::SPHERE && border.is_tangent()));
}

/// Whether a face leaves a curved surface little by little across the side from vertex v to w, by
/// which it is beside a face on it: it departs from the surface less than a plane that is tangent
/// to it where they meet would, and more than the tolerance. Else its curvature is another one.
inline bool departs_gradually(const Tessellation& mesh, const Fitted_surface<>& s,
                              Surface::Index face, Surface::Index v, Surface::Index w)
{
  constexpr double much_less = 0.7;
  if (!mesh.has_normal(face) || !mesh.has_normal_of(s, face))
    return false;
  const Double_3 p = mesh.surface.point(v), side = mesh.surface.point(w) - p;
  const Double_3 along = (1 / norm(side)) * side;
  Double_3 foot = p, perpendicular{0, 0, 0}; // to the vertex that is farthest from the side
  for (const Surface::Index u : mesh.surface.corners(face)) {
    const Double_3 d = mesh.surface.point(u) - p, across = d - dot(d, along) * along;
    if (squared_norm(across) > squared_norm(perpendicular)) {
      foot = p + d - across;
      perpendicular = across;
    }
  }
  const double height = norm(perpendicular);
  const Double_3 normal = surface_normal(s, foot),
                 tangent = perpendicular - dot(perpendicular, normal) * normal;
  const Surface_distance distance(s);
  const double apart = std::fabs(distance(foot + perpendicular));
  if (!(norm(tangent) > 0) || apart <= mesh.tolerance())
    return false;
  return apart < much_less *
                   std::fabs(distance(foot + (height / norm(tangent)) * tangent) - distance(foot));
}

/// The share of the border where the mesh leaves the surface little by little to faces that
/// `is_free(face)`: growing has stopped in the middle of a face that is not on this surface, but
/// only osculated by it.
template <typename IsFree>
double gradual_border(const Tessellation& mesh, const Face_grower& grower,
                      const Fitted_surface<>& s, const IsFree& is_free)
{
  double share = 0, all = 0;
  for (const Surface::Index f : grower.faces())
    for_each_neighbor(mesh.surface, f, [&](Surface::Index g, Surface::Index v, Surface::Index w) {
      if (grower.is_taken(g))
        return;
      const double length = norm(mesh.surface.point(w) - mesh.surface.point(v));
      all += length;
      share += is_free(g) && departs_gradually(mesh, s, g, v, w) ? length : 0;
    });
  return all > 0 ? share / all : 0;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_SURFACE_EVIDENCE_H
