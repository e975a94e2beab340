// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_INTRINSIC_FRAME_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_INTRINSIC_FRAME_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Surface.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A right-handed frame and a unit that move with a surface: coordinates in it do not depend on
/// motion, scale and numbering, but for rounding.
///
/// The origin is the centroid, the unit the largest distance of a vertex from it. The first axis
/// leads to such a vertex, the second one away from the first to the vertex farthest from that. Of
/// several as far, those with the largest faces are candidates; of these, the two with the largest
/// integral of t^3 + t^4 over the surface, t the coordinate along a direction that is generic in
/// the frame. Those left are equal by a rotation of the surface, save shapes whose moments up to
/// the fourth hide that they are not.
class Intrinsic_frame
{
  using Index = Surface::Index;

public:
  /// Generic in the frame: an order along it is one of all points, in practice.
  static constexpr Double_3 direction = {1, 0.7548776662466927, 0.5698402909980532};

  /// That of the surface itself.
  Intrinsic_frame() = default;
  /// `counts(f)`: whether a face does
  template <typename Counts>
  Intrinsic_frame(const Surface& surface, const Counts& counts)
    : m_unit(0)
  {
    set_places(surface, counts);
    for (const Place& p : m_places)
      m_unit = (std::max)(m_unit, norm(p.point));
    if (m_unit == 0)
      m_unit = 1;
    for (Place& p : m_places)
      p.point = (1 / m_unit) * p.point;
    set_axes();
    m_places = {};
  }

  /// In units of the surface.
  double unit() const { return m_unit; }

  /// The coordinates of a point of the surface: in [-1, 1] where faces count.
  Double_3 operator()(const Double_3& point) const
  {
    return coordinates((1 / m_unit) * (point - m_origin), m_axes);
  }

  /// The vector of the surface with the given coordinates, for lengths in the unit of the frame.
  Double_3 vector(const Double_3& v) const
  {
    return v.x * m_axes[0] + v.y * m_axes[1] + v.z * m_axes[2];
  }
  /// The point of the surface with the given coordinates.
  Double_3 point(const Double_3& v) const { return m_origin + m_unit * vector(v); }

private:
  using Axes = std::array<Double_3, 3>;
  static constexpr double rounding = 1e-9;           // what is less by such a share is as large
  static constexpr std::size_t most_candidates = 16; // of an axis

  struct Place // of a vertex
  {
    Double_3 point; // relative to the origin, in its unit
    double area;    // the share of the vertex in that of its faces
  };

  /// In units of the surface.
  template <typename Counts>
  void set_places(const Surface& surface, const Counts& counts)
  {
    constexpr double unused = -1;
    std::vector<double> areas(surface.number_of_vertices(), unused);
    for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
      if (!counts(f))
        continue;
      const double share = surface.area(f) / double(surface.number_of_corners(f));
      for_each_side(surface, f,
                    [&](Index v, Index) { areas[v] = (std::max)(areas[v], 0.0) + share; });
    }
    m_places.reserve(areas.size());
    for (std::size_t v = 0; v < areas.size(); ++v)
      if (areas[v] != unused)
        m_places.push_back({surface.point(v), areas[v]});
    if (m_places.empty())
      return;
    const Double_3 first = m_places[0].point; // avoids cancellation far from the origin
    Double_3 sum{0, 0, 0};
    double area = 0;
    for (const Place& p : m_places) {
      sum = sum + p.area * (p.point - first);
      area += p.area;
    }
    m_origin = first + (area > 0 ? 1 / area : 0) * sum;
    for (Place& p : m_places)
      p.point = p.point - m_origin;
  }

  void set_axes()
  {
    double largest = -std::numeric_limits<double>::infinity();
    for (const Double_3& p : farthest({0, 0, 0})) {
      const Double_3 a = (1 / norm(p)) * p;
      for (const Double_3& q : farthest(a)) {
        const Double_3 away = q - dot(q, a) * a, b = (1 / norm(away)) * away;
        const Axes axes = {a, b, cross(a, b)};
        if (const double m = moment(axes); m > largest) {
          largest = m;
          m_axes = axes;
        }
      }
    }
  }

  /// The places farthest from an axis through the origin, or from the origin if that is 0: of these
  /// those with the largest area. None if all are on the axis.
  std::vector<Double_3> farthest(const Double_3& axis) const
  {
    std::vector<double> distances(m_places.size()); // squared
    for (std::size_t i = 0; i < m_places.size(); ++i)
      distances[i] = squared_norm(m_places[i].point - dot(m_places[i].point, axis) * axis);
    double distance = 0, area = 0;
    for (const double d : distances)
      distance = (std::max)(distance, d);
    const auto is_far = [&](std::size_t i) { return distances[i] >= (1 - rounding) * distance; };
    for (std::size_t i = 0; i < m_places.size(); ++i)
      if (is_far(i))
        area = (std::max)(area, m_places[i].area);
    std::vector<Double_3> result;
    if (distance > rounding)
      for (std::size_t i = 0; i < m_places.size(); ++i)
        if (is_far(i) && m_places[i].area >= (1 - rounding) * area &&
            result.size() < most_candidates)
          result.push_back(m_places[i].point);
    return result;
  }

  double moment(const Axes& axes) const
  {
    double sum = 0;
    for (const Place& p : m_places) {
      const double t = dot(coordinates(p.point, axes), direction);
      sum += p.area * t * t * t * (1 + t);
    }
    return sum;
  }

  static Double_3 coordinates(const Double_3& v, const Axes& axes)
  {
    return {dot(v, axes[0]), dot(v, axes[1]), dot(v, axes[2])};
  }

  std::vector<Place> m_places; // of the vertices that faces use, while the frame is made; no crumbs
  Double_3 m_origin{0, 0, 0};
  double m_unit = 1;
  Axes m_axes{Double_3{1, 0, 0}, Double_3{0, 1, 0}, Double_3{0, 0, 1}};
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_INTRINSIC_FRAME_H
