// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_IS_CONVEX_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_IS_CONVEX_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Surface.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The largest share that concave edges have in the sum of length times deviation of a convex
/// surface: rounding, and quads that are divided along the wrong diagonal. Independent of the
/// resolution, as a bound on angles would not be.
constexpr double largest_concave_share_of_convex = 1e-3;
/// The largest sum of the area vectors of a closed surface, relative to that of the areas.
constexpr double largest_gap_of_closed = 1e-6;

/// Whether all components of a surface but crumbs bound convex bodies: it is closed, and has no
/// concave edges. (A closed surface that is convex at all edges is convex: van Heijenoort 1952.)
/// False for one without area. O(F).
inline bool is_convex(const Surface& mesh)
{
  Double_3 sum = {0, 0, 0};
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    sum = sum + mesh.weight(f) * mesh.normal(f);
  if (!(norm(sum) <= largest_gap_of_closed * mesh.area()) || mesh.area() == 0)
    return false;
  double squared_lengths = 0;
  for (const double l : arrays_of(mesh).squared_lengths)
    squared_lengths += l;
  // A bound of the length of the edges whose angles are not known yet, by Cauchy's inequality;
  // above rounding.
  double length = (1 + 1e-6) * std::sqrt(double(mesh.number_of_adjacencies()) * squared_lengths);
  double concave = 0, convex = 0;
  for (std::size_t e = 0; e < mesh.number_of_adjacencies(); ++e) {
    if (!mesh.has_flag(e, Surface::CONCAVE | Surface::CONVEX) || mesh.is_crumb(mesh.lower_face(e)))
      continue;
    (mesh.has_flag(e, Surface::CONCAVE) ? concave : convex) += mesh.length(e) * mesh.deviation(e);
    length -= mesh.length(e);
    // Angles are expensive, and a few are sufficient for most surfaces: no edge adds more than pi.
    if (concave > largest_concave_share_of_convex * (concave + convex + 4 * length))
      return false;
  }
  return concave <= largest_concave_share_of_convex * (concave + convex);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_IS_CONVEX_H
