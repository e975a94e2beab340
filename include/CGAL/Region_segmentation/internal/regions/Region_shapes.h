// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_REGION_SHAPES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_REGION_SHAPES_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/support/Second_moments.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The shape of every region, and the centroid of the surface.
struct Region_shapes
{
  using Index = Partition::Index;

  std::vector<double> areas;
  std::vector<Double_3> normals;   // of length 1, or zero
  std::vector<Double_3> centroids; // that of a region without area is the first face's of the mesh
  Double_3 surface_centroid{0, 0, 0};

  /// See `Learned_annotator`; not of a surface without area.
  std::vector<Double_3> area_vectors;
  std::vector<Second_moments> moments;

  Region_shapes() = default;

  Region_shapes(const Surface& mesh, const Partition& regions)
    : Region_shapes(regions.number_of_parts())
  {
    if (mesh.number_of_faces() == 0)
      return;
    const std::vector<bool> all(areas.size(), true);
    sum_up(mesh, regions, all);
    for (const Double_3& sum : centroids)
      surface_centroid = surface_centroid + sum;
    surface_centroid = mesh.centroid(0) + inverse(mesh.area()) * surface_centroid;
    divide(mesh, all);
  }

  /// The shapes of other regions. `former_of`: by region, an equal one among the former ones, or a
  /// number that none has
  Region_shapes of_changed_regions(const Surface& mesh, const Partition& regions,
                                   const std::vector<Index>& former_of) const
  {
    Region_shapes result(regions.number_of_parts());
    result.surface_centroid = surface_centroid;
    std::vector<bool> is_new(former_of.size());
    for (std::size_t r = 0; r < former_of.size(); ++r) {
      const Index former = former_of[r];
      is_new[r] = former >= areas.size();
      if (is_new[r])
        continue;
      result.areas[r] = areas[former];
      result.normals[r] = normals[former];
      result.centroids[r] = centroids[former];
      result.area_vectors[r] = area_vectors[former];
      result.moments[r] = moments[former];
    }
    result.sum_up(mesh, regions, is_new);
    result.divide(mesh, is_new);
    return result;
  }

private:
  /// The variance of an equilateral triangle of area 1 along a direction in its plane: 1 / (6
  /// sqrt(3)).
  static constexpr double variance_of_triangle = 0.096225044864937627;

  explicit Region_shapes(std::size_t number)
    : areas(number)
    , normals(number)
    , centroids(number)
    , area_vectors(number)
    , moments(number)
  {}

  /// Sums over the faces, in order, of the regions that are `wanted`.
  void sum_up(const Surface& mesh, const Partition& regions, const std::vector<bool>& wanted)
  {
    const Double_3 origin = mesh.centroid(0); // avoids cancellation far from the origin
    const double per_area = inverse(mesh.area()), per_length = 1 / mesh.length_unit();
    for (std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
      const Index r = regions[f];
      if (!wanted[r])
        continue;
      const double area = mesh.weight(f), share = per_area * area;
      const Double_3 &normal = mesh.normal(f), centroid = mesh.centroid(f) - origin;
      areas[r] += area;
      normals[r] = normals[r] + area * normal;
      centroids[r] = centroids[r] + area * centroid;
      area_vectors[r] = area_vectors[r] + share * normal;
      moments[r].add(share, per_length * centroid);
      const double variance = share * variance_of_triangle;
      Symmetric_3& second = moments[r].second;
      second.xx += share * variance;
      second.yy += share * variance;
      second.zz += share * variance;
      second.add_square(-share * variance, normal);
    }
  }

  /// Sums become means.
  void divide(const Surface& mesh, const std::vector<bool>& wanted)
  {
    for (std::size_t r = 0; r < areas.size(); ++r)
      if (wanted[r]) {
        const double length = norm(normals[r]);
        normals[r] = length > 0 ? (1 / length) * normals[r] : Double_3{};
        centroids[r] = mesh.centroid(0) + inverse(areas[r]) * centroids[r];
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
