// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_COORDINATE_RESOLUTION_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_COORDINATE_RESOLUTION_H

#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Calls `f(x)` for the coordinates of all vertices in units of the mesh, until it returns false.
/// Returns whether it never did.
template <typename F>
bool all_coordinates(const Surface& surface, const F& f)
{
  for (std::size_t v = 0; v < surface.number_of_vertices(); ++v) {
    const Double_3& p = surface.point(v);
    if (!f(surface.unit() * p.x) || !f(surface.unit() * p.y) || !f(surface.unit() * p.z))
      return false;
  }
  return true;
}

/// The step, in units of the surface, of which all coordinates in the largest decade are multiples:
/// a power of ten where they were written with few digits, else that of float; 0 if they need
/// double, or the step is more than 1/1000 of the size, as in a model of integer coordinates.
inline double coordinate_resolution(const Surface& surface)
{
  constexpr double coarsest = 1e-3;
  constexpr int digits = 14;
  double largest = 0;
  all_coordinates(surface,
                  [&](double x) { return largest = (std::max)(largest, std::fabs(x)), true; });
  if (!(largest > 0))
    return 0;
  const double size = surface.unit() * surface.length_unit();
  const int first = int(std::floor(std::log10(largest)));
  const double decade = std::pow(10.0, first);
  for (int i = 1; i < digits; ++i) {
    const double steps = std::pow(10.0, i - first); // in 1
    if (std::isfinite(steps) && steps > 0 && all_coordinates(surface, [&](double x) {
          constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
          const double n = x * steps;
          return std::fabs(x) < decade || std::fabs(n - std::round(n)) <= rounding * std::fabs(n);
        }))
      return 1 / steps <= coarsest * size ? 1 / steps / surface.unit() : 0;
  }
  const bool is_float = all_coordinates(surface, [](double x) { return double(float(x)) == x; });
  const double step = largest * std::numeric_limits<float>::epsilon();
  return is_float && step <= coarsest * size ? step / surface.unit() : 0;
}

/// The largest distance from their surface that vertices have by rounding.
inline double tolerance_of_rounding(const Surface& surface)
{
  return (std::max)(1e-6 * surface.length_unit(), coordinate_resolution(surface));
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_COORDINATE_RESOLUTION_H
