// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_NORMAL_SECTION_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_NORMAL_SECTION_H

#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/regions/Face_links.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The signed angle between the normals of the faces beside an edge, in radians, positive where it is convex.
inline double bend(const Flat_mesh& flat, const Face_links& links, const Face_edge& e)
{
  const Double_3 &n = flat.normal(e.face), &m = flat.normal(links.opposite(e).face);
  const Double_3 d = links.target(e) - links.source(e);
  return std::atan2(dot(cross(n, m), d) / norm(d), dot(n, m));
}

/// How far a face reaches from the line through one of its edges.
inline double height(const Flat_mesh& flat, const Face_links& links, const Face_edge& e)
{
  const Double_3 p = links.source(e), d = links.target(e) - p;
  const Double_3 inwards = cross(flat.normal(e.face), (1 / norm(d)) * d);
  double result = 0;
  for (std::size_t i = 0; i < flat.points().number_of_corners(e.face); ++i)
    result = (std::max)(result, dot(flat.points()[flat.points().corner(e.face, i)] - p, inwards));
  return result;
}

/// The surface on one side of an edge, along the straight path over the faces that leaves the middle of the edge at a
/// right angle: a polygon in the plane of the normal, which bends at the edges that it crosses.
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
  Normal_section(const Flat_mesh& flat, const Face_links& links, Face_edge e, double reach, double flat_angle,
                 double crease_angle)
  {
    const Double_3 along = links.target(e) - links.source(e);
    Double_3 place = 0.5 * (links.source(e) + links.target(e));
    Double_3 direction = cross(flat.normal(e.face), (1 / norm(along)) * along);
    double first_bend = -1, weighted_turn = 0;
    bool is_ended = false;
    for (int crossings = 0; crossings < most_crossings; ++crossings) {
      const auto [exit, distance] = exit_of(flat, links, e, place, direction);
      if (!(length + distance < reach)) {
        length = reach;
        break;
      }
      length += distance;
      place = place + distance * direction;
      const Face_edge next = links.opposite(exit);
      const double angle = next.exists() ? bend(flat, links, exit) : 0;
      is_ended = !next.exists() || std::abs(angle) > crease_angle;
      if (is_ended)
        break;
      // The path is straight: it makes the same angle with the edge on both sides.
      const Double_3 edge = links.target(exit) - links.source(exit);
      const Double_3 axis = (1 / norm(edge)) * edge;
      const double parallel = dot(direction, axis), across = std::sqrt((std::max)(0.0, 1 - parallel * parallel));
      direction = parallel * axis + across * cross(axis, flat.normal(next.face));
      weighted_turn += angle * across * (1 - length / reach);
      if (first_bend < 0 && std::abs(angle) > flat_angle)
        first_bend = length;
      e = next;
    }
    facet_length = first_bend < 0 ? length : first_bend;
    is_open = is_ended && first_bend < 0;
    const auto weight = [reach](double s) { return s - s * s / (2 * reach); }; // of the path up to s
    const double total = weight(length) - weight(facet_length / 2), least = 1e-3;
    curvature = total > least * reach ? weighted_turn / total : 0;
  }

private:
  static constexpr int most_crossings = 200;

  struct Exit
  {
    Face_edge edge;
    double distance;
  };

  /// The edge at which a path leaves a face that it entered at `entry`; at an infinite distance if rounding hides it.
  static Exit exit_of(const Flat_mesh& flat, const Face_links& links, const Face_edge& entry, const Double_3& place,
                      const Double_3& direction)
  {
    const double parallel = 1e-14; // cosine, relative to the length of the edge
    Exit result{entry, (std::numeric_limits<double>::infinity)()};
    Face_edge e{entry.face, 0};
    for (; e.corner < flat.points().number_of_corners(e.face); ++e.corner) {
      const Double_3 edge = links.target(e) - links.source(e);
      const Double_3 outwards = cross(edge, flat.normal(e.face));
      const double speed = dot(outwards, direction);
      if (e.corner == entry.corner || !(speed > parallel * norm(edge)))
        continue;
      const double distance = (std::max)(0.0, dot(outwards, links.source(e) - place) / speed);
      if (distance < result.distance)
        result = {e, distance};
    }
    return result;
  }
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_NORMAL_SECTION_H
