// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_REGION_SHAPES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_REGION_SHAPES_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/Partition.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Area, mean normal and centroid of every region, and the centroid of the surface.
struct Region_shapes
{
  std::vector<double> areas;
  std::vector<Double_3> normals;   // of length 1, or zero
  std::vector<Double_3> centroids; // that of a region without area is the first face's of the mesh
  Double_3 surface_centroid{0, 0, 0};

  Region_shapes() = default;

  Region_shapes(const Surface& mesh, const Partition& regions)
    : areas(regions.number_of_parts())
    , normals(regions.number_of_parts())
    , centroids(regions.number_of_parts())
  {
    if (mesh.number_of_faces() == 0)
      return;
    const Double_3 origin = mesh.centroid(0); // avoids cancellation far from the origin
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
      const Partition::Index r = regions[f];
      const double area = mesh.weight(f);
      areas[r] += area;
      normals[r] = normals[r] + area * mesh.normal(f);
      centroids[r] = centroids[r] + area * (mesh.centroid(f) - origin);
    }
    for (std::size_t r = 0; r < areas.size(); ++r)
      surface_centroid = surface_centroid + centroids[r];
    const double area = mesh.area();
    surface_centroid = origin + inverse(area) * surface_centroid;
    for (std::size_t r = 0; r < areas.size(); ++r) {
      const double length = norm(normals[r]);
      normals[r] = length > 0 ? (1 / length) * normals[r] : Double_3{};
      centroids[r] = origin + inverse(areas[r]) * centroids[r];
    }
  }

private:
  /// 0 if the area is so small that its inverse would be infinite.
  static double inverse(double area)
  {
    return area >= (std::numeric_limits<double>::min)() ? 1 / area : 0;
  }
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_REGION_SHAPES_H
