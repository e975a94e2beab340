// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_RAW_SURFACE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_RAW_SURFACE_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/internal/support/arrays.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A surface as it is read: its points and corners, and the face across each side, as far as it is
/// known.
///
/// A *side* of a face leads from one of its corners to the next one, and has the index of that
/// corner.
struct Raw_surface
{
  using Index = Surface::Index;
  static constexpr Index none = Surface::none, at_seam = none - 1;

  Surface surface;
  /// By side: the face across; `none`: of a border, or not known; or `at_seam`.
  Large_array<Index> neighbors;

  static bool is_face(Index neighbor) { return neighbor < at_seam; }
};

/// Lets the boundary of each face begin at its vertex of lowest index.
inline void begin_at_lowest_vertices(Raw_surface& raw, const Execution& execution)
{
  Surface_arrays& arrays = arrays_of(raw.surface);
  for_each_index(execution, arrays.first_corners.size() - 1, [&](std::size_t f) {
    const std::size_t first = arrays.first_corners[f], past = arrays.first_corners[f + 1];
    Surface::Index *const corners = arrays.corners.data(), *const neighbors = raw.neighbors.data();
    const auto lowest = std::min_element(corners + first, corners + past) - corners;
    std::rotate(corners + first, corners + lowest, corners + past);
    std::rotate(neighbors + first, neighbors + lowest, neighbors + past);
  });
}

/// The corner of a face that follows another one around it.
inline Surface::Index next_corner(const Surface_arrays& arrays, std::size_t face,
                                  std::size_t corner)
{
  return Surface::Index(corner + 1 == arrays.first_corners[face + 1] ? arrays.first_corners[face]
                                                                     : corner + 1);
}

/// The side of the neighbor of a face across one of its sides.
/// \pre there is a neighbor
inline Surface::Index side_across(const Raw_surface& raw, Surface::Index face, Surface::Index side)
{
  const Surface_arrays& arrays = arrays_of(raw.surface);
  const Surface::Index neighbor = raw.neighbors[side], v = arrays.corners[side],
                       w = arrays.corners[next_corner(arrays, face, side)];
  Surface::Index s = arrays.first_corners[neighbor];
  for (; s < arrays.first_corners[neighbor + 1]; ++s) {
    const Surface::Index from = arrays.corners[s],
                         to = arrays.corners[next_corner(arrays, neighbor, s)];
    if (raw.neighbors[s] == face && ((from == w && to == v) || (from == v && to == w)))
      break;
  }
  return s;
}

/// Calls `f(face, side, next)` for the open sides, whose neighbor is not known, in order: few of
/// most meshes, all of polygons. `next`: the corner to which the side leads
template <typename F>
void for_each_open_side(const Raw_surface& raw, const F& f)
{
  using Index = Surface::Index;
  const Surface_arrays& arrays = arrays_of(raw.surface);
  const auto& first_corners = arrays.first_corners;
  for (Index face = 0; face + 1 < first_corners.size(); ++face)
    for (Index side = first_corners[face]; side < first_corners[face + 1]; ++side)
      if (raw.neighbors[side] == Raw_surface::none)
        f(face, side, next_corner(arrays, face, side));
}

/// The faces with open sides, ascending.
inline std::vector<Surface::Index> faces_with_open_sides(const Raw_surface& raw)
{
  std::vector<Surface::Index> faces;
  for_each_open_side(raw, [&](Surface::Index face, Surface::Index, Surface::Index) {
    if (faces.empty() || faces.back() != face)
      faces.push_back(face);
  });
  return faces;
}

/// Chooses the unit of the points, and scales them. Those that no face uses may be anything, and
/// become the origin.
/// \throws Invalid_input if another one is not finite
inline void set_unit(Surface& surface)
{
  Surface_arrays& arrays = arrays_of(surface);
  std::vector<bool> is_used(arrays.points.size());
  for (const Surface::Index v : arrays.corners)
    is_used[v] = true;
  double largest = 0;
  for (std::size_t v = 0; v < arrays.points.size(); ++v) {
    Double_3& p = arrays.points[v];
    if (!is_used[v])
      p = {0, 0, 0};
    if (!is_finite(p))
      throw Invalid_input("the point of vertex " + std::to_string(v) + " is not finite");
    largest = (std::max)({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  arrays.unit = unit_of_coordinates(largest);
  if (arrays.unit != 1)
    for (Double_3& p : arrays.points)
      p = (1 / arrays.unit) * p;
}

/// The points and the corners of polygons. No neighbor is known yet.
/// \throws Invalid_input if a polygon has no corner or one that is not a point, or a point is not
///         finite
template <typename PointRange, typename PolygonRange>
Raw_surface read_polygons(const PointRange& points, const PolygonRange& polygons,
                          const Execution& execution)
{
  using Index = Surface::Index;
  Raw_surface raw;
  Surface_arrays& arrays = arrays_of(raw.surface);
  const auto size = std::size_t(std::distance(std::begin(polygons), std::end(polygons)));
  arrays.points.reserve(std::size_t(std::distance(std::begin(points), std::end(points))));
  arrays.first_corners.reserve(size + 1);
  arrays.corners.reserve(3 * size); // for triangles
  for (const auto& p : points)
    arrays.points.push_back({CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])});
  arrays.first_corners.push_back(0);
  for (const auto& polygon : polygons) {
    const auto place = [&] { return "polygon " + std::to_string(arrays.first_corners.size() - 1); };
    for (const auto& v : polygon) {
      static_assert(std::is_integral<std::decay_t<decltype(v)>>::value,
                    "polygons are ranges of indices of points: of an integral type");
      if (!(v >= 0 && std::size_t(v) < arrays.points.size()))
        throw Invalid_input(place() + " has a corner " + std::to_string(v) + ", but there are " +
                            std::to_string(arrays.points.size()) + " points");
      arrays.corners.push_back(Index(v));
    }
    if (arrays.corners.size() == arrays.first_corners.back())
      throw Invalid_input(place() + " has no corners");
    if (arrays.corners.size() >= Raw_surface::none)
      throw Invalid_input("the polygons have fewer than 2^32 - 1 corners");
    arrays.first_corners.push_back(Index(arrays.corners.size()));
  }
  set_unit(raw.surface);
  raw.neighbors.assign(arrays.corners.size(), Raw_surface::none);
  begin_at_lowest_vertices(raw, execution);
  return raw;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_RAW_SURFACE_H
