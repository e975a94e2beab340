// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_MEASURES_MEAN_DISTANCE_TO_CENTROID_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_MEASURES_MEAN_DISTANCE_TO_CENTROID_H

#include <CGAL/Region_segmentation/Surface.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The centroid of a polygon whose area is not 0: that of the triangles of its fan, each with its
/// area as seen along the area vector, so that it may be concave.
inline Double_3 centroid(const std::vector<Double_3>& polygon)
{
  const Double_3 origin = polygon[0];
  Double_3 area_vector{0, 0, 0}, sum{0, 0, 0};
  for (std::size_t i = 2; i < polygon.size(); ++i)
    area_vector = area_vector + cross(polygon[i - 1] - origin, polygon[i] - origin);
  const double area = norm(area_vector);
  const Double_3 normal = 1 / area * area_vector; // the square of the area may underflow
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Double_3 u = polygon[i - 1] - origin, v = polygon[i] - origin;
    sum = sum + dot(cross(u, v), normal) / area * (u + v);
  }
  return origin + 1. / 3 * sum;
}

/// The mean distance of the surface to its centroid: the centroids of the faces stand for them,
/// weighted by area. 0 where the surface has no area.
inline double mean_distance_to_centroid(const Surface& mesh)
{
  std::vector<double> weights;
  std::vector<Double_3> centers, polygon;
  double area = 0, sum_of_distances = 0;
  Double_3 sum{0, 0, 0};
  for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    if (!(mesh.area(f) > 0))
      continue;
    polygon.clear();
    for (std::size_t i = 0; i < mesh.number_of_corners(f); ++i)
      polygon.push_back(mesh.point(mesh.corner(f, i)));
    weights.push_back(mesh.area(f));
    centers.push_back(centroid(polygon));
    area += weights.back();
    sum = sum + weights.back() * centers.back();
  }
  for (std::size_t i = 0; i < centers.size(); ++i)
    sum_of_distances += weights[i] * norm(centers[i] - 1 / area * sum);
  return area > 0 ? sum_of_distances / area : 0;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_MEASURES_MEAN_DISTANCE_TO_CENTROID_H
