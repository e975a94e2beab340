// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_NORMAL_SECTION_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_NORMAL_SECTION_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/regions/Face_links.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The signed angle between the normals of the faces beside an edge, in radians, positive where it is convex.
inline double bend(const Surface& flat, const Face_links& links, const Face_edge& e)
{
  const Double_3 &n = flat.normal(e.face), &m = flat.normal(links.opposite(e).face);
  const Double_3 d = links.target(e) - links.source(e);
  return std::atan2(dot(cross(n, m), d) / norm(d), dot(n, m));
}

/// How far a face reaches from the line through one of its edges.
inline double height(const Surface& flat, const Face_links& links, const Face_edge& e)
{
  const Double_3 p = links.source(e), d = links.target(e) - p;
  const Double_3 inwards = cross(flat.normal(e.face), (1 / norm(d)) * d);
  double result = 0;
  for (std::size_t i = 0; i < flat.number_of_corners(e.face); ++i)
    result = (std::max)(result, dot(flat.point(flat.corner(e.face, i)) - p, inwards));
  return result;
}

/// The straight path over the faces that leaves the middle of an edge at a right angle.
class Normal_path
{
public:
  static constexpr int most_crossings = 200;

  Normal_path(const Surface& flat, const Face_links& links, const Face_edge& e)
    : m_flat(flat), m_links(links), m_entry(e), m_exit(e), m_place(0.5 * (links.source(e) + links.target(e)))
  {
    const Double_3 along = links.target(e) - links.source(e);
    m_direction = cross(flat.normal(e.face), (1 / norm(along)) * along);
  }

  /// Goes to the next edge. Returns the distance, which is infinite if rounding hides the edge.
  double go_to_exit()
  {
    const double parallel = 1e-14; // cosine, relative to the length of the edge
    double nearest = (std::numeric_limits<double>::infinity)();
    Face_edge e{m_entry.face, 0};
    for (; e.corner < m_flat.number_of_corners(e.face); ++e.corner) {
      const Double_3 edge = m_links.target(e) - m_links.source(e);
      const Double_3 outwards = cross(edge, m_flat.normal(e.face));
      const double speed = dot(outwards, m_direction);
      if (e.corner == m_entry.corner || !(speed > parallel * norm(edge)))
        continue;
      const double distance = (std::max)(0.0, dot(outwards, m_links.source(e) - m_place) / speed);
      if (distance < nearest) {
        nearest = distance;
        m_exit = e;
      }
    }
    m_place = m_place + nearest * m_direction;
    return nearest;
  }

  /// Whether there is a face behind the edge.
  bool goes_on() const { return m_links.opposite(m_exit).exists(); }
  /// The angle of the surface at the edge.
  double bend_at_exit() const { return goes_on() ? bend(m_flat, m_links, m_exit) : 0; }

  /// Enters the face behind the edge. Returns the sine of the angle to the edge, which is the same on both sides.
  double cross_edge()
  {
    const Face_edge next = m_links.opposite(m_exit);
    const Double_3 edge = m_links.target(m_exit) - m_links.source(m_exit);
    const Double_3 axis = (1 / norm(edge)) * edge;
    const double parallel = dot(m_direction, axis), across = std::sqrt((std::max)(0.0, 1 - parallel * parallel));
    m_direction = parallel * axis + across * cross(axis, m_flat.normal(next.face));
    m_entry = next;
    return across;
  }

private:
  const Surface& m_flat;
  const Face_links& m_links;
  Face_edge m_entry, m_exit;
  Double_3 m_place, m_direction;
};

/// How far the facet beside an edge reaches: its face, or the flat piece of the surface along the path. Faces may be slivers of
/// the facet, or a fine triangulation of it.
inline double facet_height(const Surface& flat, const Face_links& links, const Face_edge& e, double flat_angle)
{
  Normal_path path(flat, links, e);
  double length = 0;
  for (int crossings = 0; crossings < Normal_path::most_crossings; ++crossings) {
    const double distance = path.go_to_exit();
    if (!std::isfinite(distance))
      break;
    length += distance;
    if (!path.goes_on() || std::abs(path.bend_at_exit()) > flat_angle)
      break;
    path.cross_edge();
  }
  return (std::max)(length, height(flat, links, e));
}

/// The surface on one side of an edge, along the path: a polygon in the plane of the normal, which bends at the edges that it
/// crosses.
///
///        e      bends b_1          b_2
///        |________|_________________|_______
///        0       s_1               s_2     reach
struct Normal_section
{
  double length = 0;       ///< of the path: the reach, or less where it ends before a crease or border
  double facet_length = 0; ///< to the first bend, or all
  double curvature = 0;    ///< mean from the middle of the first facet on, weighted down to 0 at the reach; signed
  bool is_open = false;    ///< it ends before a crease or border, and has not bent before: the curvature is unknown

  /// Bends of at most `flat_angle` (radians) do not count; those above `crease_angle` end the path.
  Normal_section(const Surface& flat, const Face_links& links, const Face_edge& e, double reach, double flat_angle,
                 double crease_angle)
  {
    Normal_path path(flat, links, e);
    double first_bend = -1, weighted_turn = 0;
    bool is_ended = false;
    for (int crossings = 0; crossings < Normal_path::most_crossings; ++crossings) {
      const double distance = path.go_to_exit();
      if (!(length + distance < reach)) {
        length = reach;
        break;
      }
      length += distance;
      const double angle = path.bend_at_exit();
      is_ended = !path.goes_on() || std::abs(angle) > crease_angle;
      if (is_ended)
        break;
      weighted_turn += angle * path.cross_edge() * (1 - length / reach);
      if (first_bend < 0 && std::abs(angle) > flat_angle)
        first_bend = length;
    }
    facet_length = first_bend < 0 ? length : first_bend;
    is_open = is_ended && first_bend < 0;
    const auto weight = [reach](double s) { return s - s * s / (2 * reach); }; // of the path up to s
    const double total = weight(length) - weight(facet_length / 2), least = 1e-3;
    curvature = total > least * reach ? weighted_turn / total : 0;
  }
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_NORMAL_SECTION_H
