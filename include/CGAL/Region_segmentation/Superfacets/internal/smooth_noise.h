// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPERFACETS_INTERNAL_SMOOTH_NOISE_H
#define CGAL_REGION_SEGMENTATION_SUPERFACETS_INTERNAL_SMOOTH_NOISE_H

#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/Surface_builder.h>
#include <CGAL/Region_segmentation/Surface/internal/collect_adjacencies.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The normal of a vertex, and how far its neighbors lie above it on average, along this normal:
/// what noise changes most.
struct Vertex_height
{
  Double_3 normal{};
  double height = 0;
};

/// The heights of the vertices of a surface, if these are at the given points. A height is 0 if its
/// square is less than 1e-5 times the area of the faces around the vertex.
inline std::vector<Vertex_height> vertex_heights(const Surface& surface,
                                                 const Large_array<Double_3>& points)
{
  using Index = Surface::Index;
  std::vector<Vertex_height> result(points.size());
  std::vector<Double_3> to_neighbors(points.size()); // sums over the faces, to both neighbors
  std::vector<std::uint32_t> numbers(points.size());
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
    for_each_side(surface, f, [&](Index v, Index w) {
      const Double_3 along = points[w] - points[v];
      to_neighbors[v] = to_neighbors[v] + along;
      to_neighbors[w] = to_neighbors[w] - along;
      ++numbers[v];
    });
    const auto corners = surface.corners(f);
    const Double_3 area = area_vector(points.data(), corners.begin(), corners.end());
    for (const Index v : corners)
      if (!surface.is_degenerate(f))
        result[v].normal = result[v].normal + 2 * area;
  }
  for (std::size_t v = 0; v < points.size(); ++v)
    if (const double twice_area = norm(result[v].normal); twice_area > 0) {
      result[v].normal = (1 / twice_area) * result[v].normal;
      const double height = dot(to_neighbors[v], result[v].normal) / (2 * numbers[v]);
      result[v].height = 2 * (height * height) > 1e-5 * twice_area ? height : 0;
    }
  return result;
}

/// Whether more than this share of the sides of faces join heights of opposite signs. Independent
/// noise of the points makes it 4/7 of the edges; of 190 models of the Princeton benchmark, and of
/// 47 of them with faces split into four, none has more than .41.
inline bool are_opposite(const Surface& surface, const std::vector<Vertex_height>& heights,
                         double share)
{
  std::size_t all = 0, opposite = 0;
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for_each_side(surface, f, [&](Surface::Index v, Surface::Index w) {
      const double product = heights[v].height * heights[w].height;
      all += product != 0;
      opposite += product < 0;
    });
  return double(opposite) > share * double(all) + std::sqrt(double(all)); // the last term excludes
                                                                          // chance
}

/// Moves the points along their normals to the heights of their neighbors. Points at creases stay:
/// their heights are more than 3 times the median of those that are not 0.
inline void smooth_points(const std::vector<Vertex_height>& heights, Large_array<Double_3>& points)
{
  std::vector<double> sizes;
  for (const Vertex_height& h : heights)
    if (h.height != 0)
      sizes.push_back(std::fabs(h.height));
  if (sizes.empty())
    return;
  const auto median = sizes.begin() + std::ptrdiff_t(sizes.size() / 2);
  std::nth_element(sizes.begin(), median, sizes.end());
  for (std::size_t v = 0; v < points.size(); ++v)
    if (std::fabs(heights[v].height) <= 3 * *median)
      points[v] = points[v] + heights[v].height * heights[v].normal;
}

/// The surface with its points moved to the height of their neighbors, except at creases, until
/// little noise is left; nothing if there is not more noise than curvature. The more noise there
/// is, the wider is the part of the surface over which an angle is then measured. O(F).
inline std::optional<Surface> without_noise(const Surface& surface, const Execution& execution)
{
  constexpr int most_rounds = 5;
  Large_array<Double_3> points; // of the vertices, if some were moved
  for (int round = 0; round < most_rounds; ++round) {
    const std::vector<Vertex_height> heights = vertex_heights(
      surface, points.empty() ? surface.points() : points);
    // The bound is a share of the sides between vertices with heights.
    if (!are_opposite(surface, heights, points.empty() ? 0.42 : 0.2))
      break;
    if (points.empty())
      points = surface.points();
    smooth_points(heights, points);
  }
  if (points.empty())
    return std::nullopt;
  Surface_builder builder(surface);
  builder.set_points(std::move(points), execution);
  return builder.finish();
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPERFACETS_INTERNAL_SMOOTH_NOISE_H
