// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_ESTIMATE_NOISE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_ESTIMATE_NOISE_H

#include <CGAL/Region_segmentation/internal/faces/Face_set.h>
#include <CGAL/Region_segmentation/internal/faces/propose_surfaces.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The tolerance for vertices that lie on their surfaces to rounding.
inline double exact_tolerance(const Surface& surface)
{
  return 1e-6 * surface.length_unit();
}

/// The largest distance of a corner of a face to the plane of another.
inline double height_over_plane(const Surface& surface, std::size_t face, std::size_t of_plane)
{
  const Double_3 point = surface.point(surface.corner(of_plane, 0));
  double largest = 0;
  for (std::size_t i = 0; i < surface.number_of_corners(face); ++i)
    largest = (std::max)(largest, std::fabs(dot(surface.normal(of_plane),
                                                surface.point(surface.corner(face, i)) - point)));
  return largest;
}

/// The share of the area of faces that have a coplanar neighbor, to rounding: there is none if
/// vertices are noisy.
inline double share_of_plane_area(const Surface& surface, const Face_neighbors& neighbors)
{
  double plane = 0;
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    for (const Face_neighbors::Neighbor& n : neighbors[f])
      if (!neighbors.is_thin(f) && !neighbors.is_thin(n.face) &&
          surface.cosine(n.adjacency) > 0.9 &&
          height_over_plane(surface, n.face, f) <= exact_tolerance(surface)) {
        plane += surface.area(f);
        break;
      }
  return plane / surface.area();
}

/// The standard deviation of the points around a face from the surface that fits them best;
/// infinite if there are too few.
inline double error_of_patch(const Surface& surface, const Face_neighbors& neighbors,
                             Face_set& patch, Surface::Index seed)
{
  constexpr std::size_t wanted = 24, fewest = 8;
  const double size = surface.length_unit();
  double least = std::numeric_limits<double>::infinity();
  if (neighbors.is_thin(seed))
    return least;
  patch.collect(neighbors, seed, wanted, [&](const Face_neighbors::Neighbor& n) {
    return neighbors.may_be_smooth(n.adjacency);
  });
  const std::vector<Double_3>& points = patch.points();
  if (points.size() < fewest)
    return least;
  const Surface_proposer propose(points, surface.centroid(seed), surface.normal(seed),
                                 Double_3{0, 0, 0}, 1e-9 * size);
  Fitted_surface<> s;
  for (const Surface_kind kind : kinds_of_surfaces) {
    const int redundant = int(points.size()) - degrees_of_freedom(kind);
    if (least > 1e-7 * size && redundant > 4)
      least = (std::min)(least,
                         propose(kind, s) * std::sqrt(double(points.size()) / double(redundant)));
  }
  return least;
}

/// The standard deviation of vertices from the surfaces on which they lie. Freeform faces and
/// patches across borders fit no surface, so this is a low quantile over patches that are spread
/// evenly over the area.
inline double estimate_noise(const Surface& surface, const Face_neighbors& neighbors,
                             Face_set& patch)
{
  constexpr int samples = 300;
  constexpr double largest = 2e-3; // times the size
  if (!(surface.area() > 0) || share_of_plane_area(surface, neighbors) > 0.05)
    return 0;
  const double size = surface.length_unit(), step = surface.area() / samples;
  std::vector<double> errors;
  double next = step / 2, sum = 0;
  for (Surface::Index f = 0; f < surface.number_of_faces(); ++f) {
    sum += surface.weight(f);
    if (sum < next)
      continue;
    const double weight = std::ceil((sum - next) / step);
    next += weight * step;
    const double error = error_of_patch(surface, neighbors, patch, f);
    errors.insert(errors.end(), error < size ? std::size_t(weight) : 0, error);
  }
  if (errors.empty())
    return 0;
  std::sort(errors.begin(), errors.end());
  return (std::min)({1.4 * errors[errors.size() / 16], 3 * errors[0], largest * size});
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_ESTIMATE_NOISE_H
