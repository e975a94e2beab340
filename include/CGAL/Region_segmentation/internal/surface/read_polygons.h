// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_READ_POLYGONS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_READ_POLYGONS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/internal/surface/Raw_surface.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

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

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_READ_POLYGONS_H
