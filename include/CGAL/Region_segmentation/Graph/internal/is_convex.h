// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_IS_CONVEX_H
#define CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_IS_CONVEX_H

#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
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

inline bool counts_for_convexity(const Surface& mesh, std::size_t edge)
{
  return mesh.has_flag(edge, Surface::CONCAVE | Surface::CONVEX) &&
         !mesh.is_crumb(mesh.lower_face(edge));
}

/// Whether concave edges surely have more than `largest_concave_share_of_convex`. Angles are
/// expensive; so they are bounded: an angle is at least the distance of the unit normals, at most
/// pi / 2 times this distance, and at most pi. Half of the edges of a fine mesh are sufficient for
/// that. The result is false for each convex surface.
inline bool is_clearly_concave(const Surface& mesh)
{
  double squared_lengths = 0; // of the edges that are not known yet
  for (std::size_t e = 0; e < mesh.number_of_adjacencies(); ++e)
    squared_lengths += mesh.squared_length(e);
  squared_lengths *= 1 + 1e-6; // rounding
  const std::size_t n = mesh.number_of_adjacencies();
  double concave = 0, convex = 0;
  const auto is_exceeded = [&](std::size_t known) {
    // the length of the others is bounded by Cauchy's inequality
    const double length = std::sqrt(double(n - known) * (std::max)(squared_lengths, 0.0));
    return concave >
           largest_concave_share_of_convex * (CGAL_PI / 2 * (concave + convex) + CGAL_PI * length);
  };
  for (std::size_t e = 0; e < n; ++e) {
    squared_lengths -= mesh.squared_length(e);
    if (counts_for_convexity(mesh, e)) {
      const Double_3 between = mesh.normal(mesh.lower_face(e)) - mesh.normal(mesh.higher_face(e));
      const double product = std::sqrt(mesh.squared_length(e) * squared_norm(between));
      (mesh.has_flag(e, Surface::CONCAVE) ? concave : convex) += product;
    }
    if (e % 256 == 255 && is_exceeded(e + 1))
      return true;
  }
  return is_exceeded(n);
}

/// Whether all components of a surface but crumbs bound convex bodies: the surface is closed, and
/// has no concave edges. (A closed surface that is convex at all edges is convex: van Heijenoort
/// 1952.) The result is false for a surface without area. O(F).
inline bool is_convex(const Surface& mesh)
{
  if (mesh.area() == 0 || is_clearly_concave(mesh))
    return false;
  Double_3 sum = {0, 0, 0};
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    sum = sum + mesh.weight(f) * mesh.normal(f);
  if (!(norm(sum) <= largest_gap_of_closed * mesh.area()))
    return false;
  double concave = 0, convex = 0;
  for (std::size_t e = 0; e < mesh.number_of_adjacencies(); ++e)
    if (counts_for_convexity(mesh, e))
      (mesh.has_flag(e, Surface::CONCAVE) ? concave : convex) += mesh.length(e) * mesh.deviation(e);
  return concave <= largest_concave_share_of_convex * (concave + convex);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_IS_CONVEX_H
