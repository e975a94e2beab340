// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_REGION_SHAPES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_REGION_SHAPES_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/support/Second_moments.h>
#include <CGAL/Region_segmentation/internal/support/for_each_in_part.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The shape of a region.
struct Region_shape
{
  double area = 0;
  Double_3 normal{0, 0, 0};   // of length 1, or zero
  Double_3 centroid{0, 0, 0}; // that of a region without area is the first face's of the mesh

  /// See `Learned_annotator`; not of a surface without area.
  Double_3 area_vector{0, 0, 0};
  Second_moments moments;
};

/// The shape of every region, and the centroid of the surface.
struct Region_shapes
{
  using Index = Partition::Index;

  std::vector<Region_shape> regions;
  Double_3 surface_centroid{0, 0, 0};

  Region_shapes() = default;

  Region_shapes(const Surface& mesh, const Partition& region_of,
                const Execution& execution = Execution())
    : regions(region_of.number_of_parts())
  {
    if (mesh.number_of_faces() == 0)
      return;
    sum_up(mesh, region_of, execution);
    for (const Region_shape& sums : regions)
      surface_centroid = surface_centroid + sums.centroid;
    surface_centroid = mesh.centroid(0) + inverse(mesh.area()) * surface_centroid;
    divide(mesh);
  }

private:
  /// The variance of an equilateral triangle of area 1 along a direction in its plane: 1 / (6
  /// sqrt(3)).
  static constexpr double variance_of_triangle = 0.096225044864937627;

  /// Sums over the faces, in order.
  void sum_up(const Surface& mesh, const Partition& region_of, const Execution& execution)
  {
    const Double_3 origin = mesh.centroid(0); // avoids cancellation far from the origin
    const double per_area = inverse(mesh.area()), per_length = 1 / mesh.length_unit();
    for_each_in_part(execution, region_of, [&](std::size_t r, std::size_t f) {
      const double area = mesh.weight(f), share = per_area * area;
      const Double_3 &normal = mesh.normal(f), centroid = mesh.centroid(f) - origin;
      Region_shape& region = regions[r];
      region.area += area;
      region.normal = region.normal + area * normal;
      region.centroid = region.centroid + area * centroid;
      region.area_vector = region.area_vector + share * normal;
      region.moments.add(share, per_length * centroid);
      const double variance = share * variance_of_triangle;
      Symmetric_3& second = region.moments.second;
      second.xx += share * variance;
      second.yy += share * variance;
      second.zz += share * variance;
      second.add_square(-share * variance, normal);
    });
  }

  /// Sums become means.
  void divide(const Surface& mesh)
  {
    for (Region_shape& region : regions) {
      const double length = norm(region.normal);
      region.normal = length > 0 ? (1 / length) * region.normal : Double_3{};
      region.centroid = mesh.centroid(0) + inverse(region.area) * region.centroid;
    }
  }

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
