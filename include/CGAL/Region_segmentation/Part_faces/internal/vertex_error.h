// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_VERTEX_ERROR_H
#define CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_VERTEX_ERROR_H

#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Face_set.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Surface_proposer.h>
#include <CGAL/Region_segmentation/Part_faces/internal/Tessellation.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The diagonal of the bounding box of the faces.
inline double size_of_surface(const Surface& surface)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Double_3 least{infinity, infinity, infinity}, greatest{-infinity, -infinity, -infinity};
  for (Surface::Index f = 0; f < surface.number_of_faces(); ++f)
    for (const Surface::Index v : surface.corners(f)) {
      const Double_3& p = surface.point(v);
      least = {(std::min)(least.x, p.x), (std::min)(least.y, p.y), (std::min)(least.z, p.z)};
      greatest = {(std::max)(greatest.x, p.x), (std::max)(greatest.y, p.y),
                  (std::max)(greatest.z, p.z)};
    }
  return surface.number_of_faces() > 0 ? norm(greatest - least) : 0;
}

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

/// Whether a coordinate is a multiple of 1 / `steps`, to rounding.
inline bool is_multiple(double x, double steps)
{
  constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  const double n = x * steps;
  return std::fabs(n - std::round(n)) <= rounding * std::fabs(n);
}

/// The power of ten, in units of the mesh, of which all coordinates from `least` on are multiples;
/// 0 if they have more than `most_digits` digits, or the last one is not one of chance: it takes
/// less than five values.
inline double decimal_step(const Surface& surface, double largest, double least, int most_digits)
{
  constexpr int fewest_values = 5;
  const int first = int(std::floor(std::log10(largest)));
  for (int i = 1; i < most_digits; ++i) {
    const double steps = std::pow(10.0, i - first); // in 1
    bool has_digit[10] = {false};
    if (std::isfinite(steps) && steps > 0 && all_coordinates(surface, [&](double x) {
          const double n = std::round(x * steps);
          has_digit[std::size_t(std::fabs(std::fmod(n, 10)))] = true;
          return std::fabs(x) < least || is_multiple(x, steps);
        }))
      return std::count(has_digit + 1, has_digit + 10, true) >= fewest_values ? 1 / steps : 0;
  }
  return 0;
}

/// The step of coordinates, in units of the surface: that of fixed decimals of all of them, else of
/// fixed digits in the largest decade, if a quarter of them is there; not less than two steps of
/// `float` at the largest one, if they are floats, or floats that were written with nine digits. 0
/// if it is more than 1/1000 of the size, as in a model of integer coordinates.
inline double coordinate_step(const Surface& surface, double size)
{
  constexpr double coarsest = 1e-3;
  double largest = 0;
  all_coordinates(surface,
                  [&](double x) { return largest = (std::max)(largest, std::fabs(x)), true; });
  if (!(largest > 0))
    return 0;
  double step = decimal_step(surface, largest, 0, 14);
  if (step == 0) {
    const double decade = std::pow(10.0, std::floor(std::log10(largest)));
    std::size_t in_decade = 0;
    all_coordinates(surface, [&](double x) { return in_decade += std::fabs(x) >= decade, true; });
    if (4 * in_decade >= 3 * surface.number_of_vertices())
      step = decimal_step(surface, largest, decade, 9);
  }
  if (all_coordinates(
        surface, [](double x) { return std::fabs(double(float(x)) - x) <= 5.1e-9 * std::fabs(x); }))
    step = (std::max)(step, 2 * largest * std::numeric_limits<float>::epsilon());
  step /= surface.unit();
  return step <= coarsest * size ? step : 0;
}

/// The height of the vertex of a triangle g that is opposite to the side from v to w over the plane
/// of the adjacent triangle f, over the standard deviation that it has if each vertex has one of 1;
/// negative where that is large.
inline double normalized_height(const Surface& surface, Surface::Index f, Surface::Index g,
                                Surface::Index v, Surface::Index w)
{
  constexpr double most = 8;
  if (surface.number_of_corners(f) != 3 || surface.number_of_corners(g) != 3 ||
      surface.is_degenerate(f))
    return -1;
  const auto opposite = [&](Surface::Index face) {
    Surface::Index result = v;
    for (const Surface::Index u : surface.corners(face))
      result = u != v && u != w ? u : result;
    return surface.point(result);
  };
  const Double_3 a = surface.point(v), ab = surface.point(w) - a, ac = opposite(f) - a,
                 d = opposite(g) - a, n = surface.normal(f);
  const double height = dot(d, n), area = 2 * surface.area(f);
  const double at_b = dot(cross(d, ac), n) / area, at_c = dot(cross(ab, d), n) / area,
               at_a = 1 - at_b - at_c,
               deviation = std::sqrt(1 + at_a * at_a + at_b * at_b + at_c * at_c);
  return deviation > most ? -1 : std::fabs(height) / deviation;
}

/// The standard deviation of vertices from the heights of flat pairs of triangles: those below the
/// widest gap between the heights of flat and of bent pairs. `least`: if there is no gap
inline double error_of_flat_pairs(const Surface& surface, double size, double least)
{
  constexpr double least_cosine = 0.5, most = 3e-4, least_gap = 2, widest_cluster = 12;
  constexpr std::size_t fewest = 8, stragglers = 50;
  std::vector<double> heights;
  for (Surface::Index f = 0; f < surface.number_of_faces(); ++f)
    for_each_neighbor(surface, f, [&](Surface::Index g, Surface::Index v, Surface::Index w) {
      if (g > f && dot(surface.normal(f), surface.normal(g)) > least_cosine)
        if (const double height = normalized_height(surface, f, g, v, w); height >= 0)
          heights.push_back(height);
    });
  if (heights.size() < fewest)
    return least;
  std::sort(heights.begin(), heights.end());
  double widest = std::log(least_gap), below = 0;
  for (std::size_t i = (std::max)(std::size_t(6), heights.size() / 200);
       i + 1 < heights.size() && heights[i] <= most * size; ++i) {
    const double above = heights[(std::min)(heights.size() - 1, i + 1 + i / stragglers)],
                 gap = std::log(above / (std::max)(heights[i], least));
    const bool is_cluster = heights[i] <= (std::max)(least, widest_cluster * heights[i / 2]);
    if (is_cluster && above > least && gap > widest) {
      widest = gap;
      below = (std::max)(heights[i], least);
    }
  }
  if (below == 0)
    return least;
  const std::size_t flat = std::size_t(std::upper_bound(heights.begin(), heights.end(), below) -
                                       heights.begin());
  // Of the absolute value of a normal variable, in standard deviations.
  constexpr double median_of_normal = 0.6745, of_largest = 5;
  return (std::max)({least, heights[flat / 2] / median_of_normal, heights[flat - 1] / of_largest});
}

/// The root mean square distance of vertices around a face from the surface that fits them best,
/// with that of the unknown parameters; not less than `least`; infinite if none fits, or they are
/// not on both sides of it by chance; 0 on an exact plane, which tells nothing of other surfaces.
inline double error_of_fit(const Surface& surface, Face_set& patch, Surface::Index seed,
                           double size, double least)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr std::size_t fewest = 14, wanted = 40;
  constexpr double smooth_cosine = 0.694, largest_area = 8, most = 5e-4, opposite_sides = 0.4;
  collect_patch(patch, surface, seed, wanted,
                [&](std::size_t i, Surface::Index other, Surface::Index, Surface::Index) {
                  return dot(surface.normal(patch.faces()[i]), surface.normal(other)) >
                           smooth_cosine &&
                         surface.area(other) < largest_area * surface.area(seed);
                });
  if (patch.points().size() < fewest)
    return infinity;
  std::vector<Oriented_piece> pieces;
  for (const Surface::Index f : patch.faces())
    pieces.push_back({surface.centroid(f), surface.normal(f), surface.area(f)});
  const Surface_proposer propose(patch.points(), pieces, 0.05 * least);
  double error = infinity;
  Fitted_surface<> best;
  for (const Surface_kind kind : kinds_of_surfaces) {
    Fitted_surface<> s;
    const double n = double(patch.points().size()), worth = kind > Surface_kind::CYLINDER ? 0.8 : 1;
    const double rms = propose(kind, most * size, s) *
                       std::sqrt(n / (n - degrees_of_freedom(kind)));
    if (rms < worth * error) {
      error = rms;
      best = s;
    }
    if (error < least)
      return kind == Surface_kind::PLANE ? 0 : least;
  }
  const Surface_distance distance(best);
  std::size_t opposite = 0, all = 0;
  for (const Surface::Index f : patch.faces())
    for_each_side(surface, f, [&](Surface::Index v, Surface::Index w) {
      opposite += distance(surface.point(v)) * distance(surface.point(w)) < 0;
      ++all;
    });
  return error <= most * size && double(opposite) >= opposite_sides * double(all) ? error
                                                                                  : infinity;
}

/// The standard deviation of vertices from the fits of patches all over the surface: `least` if
/// three are that good, else that of the lower third; 0 if too few fit.
inline double error_of_fits(const Surface& surface, double size, double least)
{
  constexpr std::size_t fewest = 12, most = 80;
  const std::size_t n = surface.number_of_faces(),
                    tried = (std::min)({n, most, (std::max)(fewest, n / most)});
  std::vector<double> errors;
  Face_set patch(surface);
  std::size_t exact = 0, exact_planes = 0;
  for (std::size_t i = 0; i < tried; ++i) {
    const Surface::Index seed = Surface::Index(evenly_spread_index(i, n));
    const double error = surface.is_degenerate(seed)
                           ? std::numeric_limits<double>::infinity()
                           : error_of_fit(surface, patch, seed, size, least);
    exact_planes += error == 0;
    exact += error > 0 && error <= 1.01 * least;
    if (exact == 3)
      return least;
    if (error > 0 && std::isfinite(error))
      errors.push_back(error);
  }
  if (errors.size() < 3 || 5 * errors.size() < tried - exact_planes)
    return 0;
  std::sort(errors.begin(), errors.end());
  return errors[errors.size() / 3];
}

/// The standard deviation of the vertices of a part from its surfaces, in units of the surface.
inline double vertex_error(const Surface& surface)
{
  constexpr double rounding = 2e-7, of_step = 0.35; // 1.2 / sqrt(12)
  const double size = size_of_surface(surface);
  const double least = (std::max)(rounding * size, of_step * coordinate_step(surface, size));
  const double fits = error_of_fits(surface, size, least);
  if (fits > 0 && fits <= 1.5 * least)
    return fits;
  const double flat = error_of_flat_pairs(surface, size, least);
  return fits == 0 ? flat : flat < 2 * fits ? (std::max)(flat, fits) : fits;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_FACES_INTERNAL_VERTEX_ERROR_H
