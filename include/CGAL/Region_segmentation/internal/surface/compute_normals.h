// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_COMPUTE_NORMALS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_COMPUTE_NORMALS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Whether a face of this area has no normal that means anything.
inline bool is_degenerate(double area, double squared_longest_edge)
{
  return !(area > 1e-12 * squared_longest_edge && area >= (std::numeric_limits<double>::min)());
}

/// The areas and normals of the faces, by Newell's formula relative to the first corner, A = 1/2
/// sum (p_i - p_0) x (p_i+1 - p_0), which avoids cancellation far from the origin. The normal of a
/// degenerate face is zero.
inline void compute_normals(Surface& surface, const Execution& execution)
{
  Surface_arrays& arrays = arrays_of(surface);
  const std::size_t size = arrays.first_corners.size() - 1;
  arrays.normals.resize(size);
  arrays.areas.resize(size);
  // Through references to the arrays it takes twice as long.
  const Double_3* const points = arrays.points.data();
  const Surface::Index *const corners = arrays.corners.data(),
                              *const first_corners = arrays.first_corners.data();
  double* const areas = arrays.areas.data();
  Double_3* const normals = arrays.normals.data();
  for_each_block(execution, size, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const Surface::Index first = first_corners[f], past = first_corners[f + 1];
      const Double_3 origin = points[corners[first]];
      Double_3 twice_area{};
      double squared_longest_edge = 0;
      if (past - first > 2)
        squared_longest_edge = (std::max)(squared_norm(points[corners[first + 1]] - origin),
                                          squared_norm(points[corners[past - 1]] - origin));
      for (Surface::Index c = first + 2; c < past; ++c) {
        const Double_3 &p = points[corners[c - 1]], &q = points[corners[c]];
        twice_area = twice_area + cross(p - origin, q - origin);
        squared_longest_edge = (std::max)(squared_longest_edge, squared_norm(q - p));
      }
      const Double_3 area_vector = 0.5 * twice_area;
      const double area = norm(area_vector);
      areas[f] = area;
      normals[f] = is_degenerate(area, squared_longest_edge) ? Double_3{}
                                                             : (1 / area) * area_vector;
    }
  });
}

/// The flags of the sign of an edge between two faces: of the normals of the higher and the lower
/// one, and the direction in which the boundary of the higher one runs.
inline std::uint8_t sign_of_edge(const Double_3& higher, const Double_3& lower,
                                 const Double_3& direction)
{
  const double sign = dot(cross(higher, lower), direction);
  return std::uint8_t((sign > 0) * Surface::CONVEX + (sign < 0) * Surface::CONCAVE);
}

/// Flags with another sign.
inline std::uint8_t with_sign(std::uint8_t flags, std::uint8_t sign)
{
  constexpr std::uint8_t signs = Surface::CONVEX | Surface::CONCAVE;
  return std::uint8_t((flags & ~signs) | sign);
}

/// Whether the boundary of a face runs from one vertex to another.
inline bool runs_along(const Surface& surface, Surface::Index face, Surface::Index from,
                       Surface::Index to)
{
  const auto [first, end] = corners_of(surface, face);
  for (const Surface::Index* next = first + 1; next != end; ++next)
    if (next[-1] == from && *next == to)
      return true;
  return end[-1] == from && *first == to;
}

/// The edges between two faces, along the boundary of the higher one: their sum and their number.
/// None of polygons of so many corners that a search of all pairs would take long.
inline std::pair<Double_3, std::size_t> common_edges(const Surface& surface, Surface::Index lower,
                                                     Surface::Index higher)
{
  constexpr std::size_t most_pairs = 256;
  std::pair<Double_3, std::size_t> result{{0, 0, 0}, 0};
  if (surface.number_of_corners(lower) * surface.number_of_corners(higher) > most_pairs)
    return result;
  for_each_side(surface, higher, [&](Surface::Index p, Surface::Index q) {
    if (runs_along(surface, lower, q, p)) {
      result.first = result.first + (surface.point(q) - surface.point(p));
      ++result.second;
    }
  });
  return result;
}

/// Sets the area of the surface and the unit of lengths by the weights of the faces, and the
/// centroids of polygons of many corners.
inline void sum_up(Surface& surface)
{
  Surface_arrays& arrays = arrays_of(surface);
  arrays.area = 0;
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    arrays.area += surface.weight(f);
  arrays.length_unit = arrays.area > 0 ? std::sqrt(arrays.area) : 1;
  arrays.centroids.clear();
  if (arrays.corners.size() > 3 * surface.number_of_faces())
    for (Surface::Index f = 0; f < surface.number_of_faces(); ++f)
      if (surface.number_of_corners(f) > Surface_arrays::many_corners)
        arrays.centroids.push_back({f, mean_of_corners(arrays, arrays.points, f)});
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_COMPUTE_NORMALS_H
