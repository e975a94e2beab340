// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_SHARED_SIDE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_SHARED_SIDE_H

#include <CGAL/Region_segmentation/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The side that two faces share, from one vertex to another; of several, one of them. `along` is 0
/// if they share no vertices. Linear time in the corners of the face that has fewer.
struct Shared_side
{
  Double_3 middle{0, 0, 0}, along{0, 0, 0};

  Shared_side(const Surface& surface, std::size_t face, std::size_t other)
  {
    if (surface.number_of_corners(face) > surface.number_of_corners(other))
      std::swap(face, other);
    const std::size_t n = surface.number_of_corners(face);
    double least = none;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t p = surface.corner(face, i), q = surface.corner(face, (i + 1) % n);
      const double distance = (std::max)(this->distance(surface, p, other),
                                         this->distance(surface, q, other));
      if (distance < least) {
        least = distance;
        set(surface.point(p), surface.point(q));
      }
    }
    if (least == none)
      middle = 0.5 * (surface.centroid(face) + surface.centroid(other));
  }

private:
  static constexpr std::size_t many = 64; // corners, among which a vertex is not searched
  static constexpr double none = (std::numeric_limits<double>::max)();

  /// 0 for a vertex of a face, else none; that from its plane where the face has many corners.
  static double distance(const Surface& surface, std::size_t vertex, std::size_t face)
  {
    const std::size_t n = surface.number_of_corners(face);
    if (n > many)
      return std::fabs(
        dot(surface.normal(face), surface.point(vertex) - surface.point(surface.corner(face, 0))));
    for (std::size_t i = 0; i < n; ++i)
      if (surface.corner(face, i) == vertex)
        return 0;
    return none;
  }

  void set(const Double_3& from, const Double_3& to)
  {
    const Double_3 d = to - from;
    middle = 0.5 * (from + to);
    along = norm(d) > 0 ? (1 / norm(d)) * d : d;
  }
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_SHARED_SIDE_H
