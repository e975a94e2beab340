// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_SMOOTH_NOISE_H
#define CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_SMOOTH_NOISE_H

#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Large_array.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/Surface_builder.h>
#include <CGAL/Region_segmentation/Surface/internal/collect_adjacencies.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The faces around a vertex.
struct Vertex_star
{
  Double_3 normal{};       ///< the sum of twice their area vectors, then of length 1
  Double_3 to_neighbors{}; ///< the sum over the faces, to both neighbors
};

/// The stars of the vertices of a surface, and their heights: how far the neighbors of a vertex lie
/// above it on average, along its normal. This is what noise changes most.
struct Vertex_heights
{
  Large_array<Vertex_star> stars;
  Large_array<double> heights; ///< 0 if the square is less than 1e-5 times the area of the star

  /// Sets them for vertices at the given points.
  void compute(const Surface& surface, const Large_array<Double_3>& points)
  {
    stars.assign(points.size(), Vertex_star());
    heights.assign(points.size(), 0);
    for (std::size_t f = 0; f < surface.number_of_faces(); ++f) {
      for_each_side(surface, f, [&](Surface::Index v, Surface::Index w) {
        const Double_3 along = points[w] - points[v];
        stars[v].to_neighbors = stars[v].to_neighbors + along;
        stars[w].to_neighbors = stars[w].to_neighbors - along;
        ++heights[v]; // at first the number of faces
      });
      const auto corners = surface.corners(f);
      const Double_3 area = area_vector(points.data(), corners.begin(), corners.end());
      for (const Surface::Index v : corners)
        if (!surface.is_degenerate(f))
          stars[v].normal = stars[v].normal + 2 * area;
    }
    for (std::size_t v = 0; v < points.size(); ++v)
      if (const double twice_area = norm(stars[v].normal); twice_area > 0) {
        stars[v].normal = (1 / twice_area) * stars[v].normal;
        const double height = dot(stars[v].to_neighbors, stars[v].normal) / (2 * heights[v]);
        heights[v] = 2 * (height * height) > 1e-5 * twice_area ? height : 0;
      } else
        heights[v] = 0;
  }

  /// Sets them for vertices at the given points, and returns whether they show noise: whether more
  /// than this share of the sides of faces join heights of opposite signs. Independent noise of the
  /// points makes it 4/7 of the edges; of 190 models of the Princeton benchmark, and of 47 of them
  /// with faces split into four, none has more than .41.
  bool show_noise(const Surface& surface, const Large_array<Double_3>& points, double share)
  {
    compute(surface, points);
    std::size_t all = 0, opposite = 0;
    for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
      for_each_side(surface, f, [&](Surface::Index v, Surface::Index w) {
        const double product = heights[v] * heights[w];
        all += product != 0;
        opposite += product < 0;
      });
    return double(opposite) > share * double(all) + std::sqrt(double(all)); // the last term
                                                                            // excludes chance
  }

  /// Moves the points along their normals to the heights of their neighbors. Points at creases
  /// stay: their heights are more than 3 times the median of those that are not 0.
  void smooth(Large_array<Double_3>& points) const
  {
    Large_array<double> sizes;
    sizes.reserve(heights.size());
    for (const double height : heights)
      if (height != 0)
        sizes.push_back(std::fabs(height));
    if (sizes.empty())
      return;
    const auto median = sizes.begin() + std::ptrdiff_t(sizes.size() / 2);
    std::nth_element(sizes.begin(), median, sizes.end());
    for (std::size_t v = 0; v < points.size(); ++v)
      if (std::fabs(heights[v]) <= 3 * *median)
        points[v] = points[v] + heights[v] * stars[v].normal;
  }
};

/// The surface with its points moved to the height of their neighbors, except at creases, until
/// little noise is left; as it is, if there is not more noise than curvature. The more noise there
/// is, the wider is the part of the surface over which an angle is then measured. O(F).
inline Surface without_noise(Surface surface, const Execution& execution)
{
  constexpr int most_rounds = 5;
  Vertex_heights heights; // its memory is used again in each round
  if (!heights.show_noise(surface, surface.points(), 0.42))
    return surface;
  Surface_builder builder(std::move(surface));
  Large_array<Double_3> points = builder.take_points();
  for (int round = 0;
       round < most_rounds && (round == 0 || heights.show_noise(builder, points, 0.2)); ++round)
    heights.smooth(points);
  heights = Vertex_heights(); // The next step needs the memory.
  builder.set_points(std::move(points), execution);
  return builder.finish();
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_SMOOTH_NOISE_H
