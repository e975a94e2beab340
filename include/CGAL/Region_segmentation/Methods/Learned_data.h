// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_LEARNED_DATA_H
#define CGAL_REGION_SEGMENTATION_METHODS_LEARNED_DATA_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/Methods/Visibility_data.h>
#include <CGAL/Region_segmentation/Methods/Whole_shape.h>
#include <CGAL/Region_segmentation/internal/support/Second_moments.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationGraph
/// In addition to `Visibility_section_data`: how lengths are distributed over angles, the thickness
/// beside the section, and its shape; filled by `Learned_annotator`. A model of `SectionData`.
///
/// All are sums over the edges, in units of the square root of the area of the surface.
struct Learned_section_data : Visibility_section_data
{
  /// \name Bounds of the deviation, in radians
  /// @{
  static constexpr double weakly_concave = 0.1, strongly_concave = 0.4, strongly_convex = 0.3;
  /// @}

  double weakly_concave_length = 0;   ///< of concave edges with a deviation above `weakly_concave`
  double strongly_concave_length = 0; ///< of concave edges with a deviation above
                                      ///< `strongly_concave`
  double strongly_convex_length = 0;  ///< of convex edges with a deviation above `strongly_convex`
  double squared_deviation = 0; ///< integral of the square of the deviation, negative on convex
                                ///< edges
  double log_thickness = 0;     ///< integral of the mean of the mean log thickness of the two first
                                ///< regions
  internal::Second_moments moments; ///< of the edges, each at the mean of the centroids of its
                                    ///< faces

  /// Accounts for a dual edge of the mesh.
  void add_adjacency(const Surface& mesh, std::size_t a)
  {
    const double unit = mesh.length_unit(), l = mesh.length(a) / unit;
    const double deviation = signed_deviation(mesh, a);
    add(l, deviation);
    const Double_3 center = 0.5 * (mesh.centroid(mesh.lower_face(a)) +
                                   mesh.centroid(mesh.higher_face(a)));
    moments.add(l, (1 / unit) * (center - mesh.centroid(0)));
    squared_deviation += l * deviation * std::abs(deviation);
    if (deviation > weakly_concave)
      weakly_concave_length += l;
    if (deviation > strongly_concave)
      strongly_concave_length += l;
    if (deviation < -strongly_convex)
      strongly_convex_length += l;
  }

  /// Adds another section between the same two regions.
  void absorb(const Learned_section_data& other)
  {
    Visibility_section_data::absorb(other);
    weakly_concave_length += other.weakly_concave_length;
    strongly_concave_length += other.strongly_concave_length;
    strongly_convex_length += other.strongly_convex_length;
    squared_deviation += other.squared_deviation;
    log_thickness += other.log_thickness;
    moments.add(other.moments);
  }
};

/// \ingroup PkgRegionSegmentationGraph
/// In addition to `Visibility_region_data`: how the thickness varies, what a region sees of itself,
/// its shape, and that of the surface; filled by `Learned_annotator`. A model of `RegionData`.
///
/// Lengths are in units of the square root of the area of the surface.
struct Learned_region_data : Visibility_region_data
{
  double squared_log_thickness = 0; ///< integral over the area of the square of the first regions'
                                    ///< mean log thickness
  double own_visibility = 0;        ///< weight of the rays that start and end in the region
  double perimeter = 0;             ///< length of the sections with other regions
  Double_3 area_vector{0, 0, 0};    ///< integral of the normal
  internal::Second_moments moments; ///< of the area
  Whole_shape whole;                ///< that of all regions

  /// Adds the region on the other side of a section. All data are added; but the visibility of the
  /// section is added to `own_visibility`, twice its length is taken from `perimeter`, and `whole`
  /// remains.
  void absorb(const Learned_region_data& other, const Learned_section_data& between)
  {
    Visibility_region_data::absorb(other, between);
    squared_log_thickness += other.squared_log_thickness;
    own_visibility += other.own_visibility + between.visibility;
    perimeter += other.perimeter - 2 * between.length;
    area_vector = area_vector + other.area_vector;
    moments.add(other.moments);
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_LEARNED_DATA_H
