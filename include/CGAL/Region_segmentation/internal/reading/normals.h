// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_NORMALS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_NORMALS_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The inverse of a smaller area is infinite.
inline bool is_degenerate(double area, double squared_longest_edge)
{
  return !(area > 1e-12 * squared_longest_edge && area >= (std::numeric_limits<double>::min)());
}

/// No face of a larger area is degenerate, if no coordinate is larger than this one: the diagonal of a cube bounds the edges.
inline double certain_area(double largest_coordinate)
{
  constexpr double squared_diagonal = 12, rounding = 1.1;
  return (std::max)(rounding * 1e-12 * squared_diagonal * largest_coordinate * largest_coordinate,
                    (std::numeric_limits<double>::min)());
}

/// `area`: the length of the area vector; `of_degenerate`: the result for a degenerate face.
inline Double_3 unit_normal(const Double_3& area_vector, double area, double squared_longest_edge,
                            const Double_3& of_degenerate)
{
  return is_degenerate(area, squared_longest_edge) ? of_degenerate : (1 / area) * area_vector;
}

/// `Flat_mesh::CONVEX`, `Flat_mesh::CONCAVE` or 0, of the normals of the higher and the lower face, and the halfedge of
/// the higher one. Both factors of the sign are reversed with respect to the definition, which does not change its value.
inline std::uint8_t sign_of_edge(const Double_3& higher, const Double_3& lower, const Double_3& direction)
{
  const double sign = dot(cross(higher, lower), direction);
  return std::uint8_t((sign > 0) * Flat_mesh::CONVEX + (sign < 0) * Flat_mesh::CONCAVE);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_NORMALS_H
