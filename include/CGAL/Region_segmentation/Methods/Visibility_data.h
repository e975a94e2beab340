// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_VISIBILITY_DATA_H
#define CGAL_REGION_SEGMENTATION_METHODS_VISIBILITY_DATA_H

#include <CGAL/Region_segmentation/Surface.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationGraph
/// Length, angles and visibility of a section, filled by `Visibility_annotator`. A model of
/// `SectionData`.
///
/// Lengths are in units of the square root of the area of the surface.
struct Visibility_section_data
{
  double length = 0;
  double concave = 0;    ///< integral of the deviation of concave edges, at most 0.6 rad each
  double convex = 0;     ///< integral of the deviation of convex edges, at most 2 rad each
  double bend = 0;       ///< integral of the angle between the mean normals of the first regions,
                         ///< positive where they face each other
  double visibility = 0; ///< weight of the rays between the two regions
  std::size_t number_of_adjacencies = 0; ///< 0: the regions see each other, but are not adjacent

  /// Accounts for a dual edge of the mesh. An edge of a degenerate face counts as flat.
  void add_adjacency(const Surface& surface, std::size_t adjacency)
  {
    add(surface.length(adjacency) / surface.length_unit(), signed_deviation(surface, adjacency));
  }

  /// Adds another section between the same two regions.
  void absorb(const Visibility_section_data& other)
  {
    length += other.length;
    concave += other.concave;
    convex += other.convex;
    bend += other.bend;
    visibility += other.visibility;
    number_of_adjacencies += other.number_of_adjacencies;
  }

protected:
  /// The deviation of an adjacency in radians: positive if it is concave, negative if it is convex.
  /// Where components touch there is a valley: a link counts as one of a right angle.
  static double signed_deviation(const Surface& surface, std::size_t adjacency)
  {
    return surface.has_flag(adjacency, Surface::LINK)      ? CGAL_PI / 2
           : surface.has_flag(adjacency, Surface::CONCAVE) ? surface.deviation(adjacency)
           : surface.has_flag(adjacency, Surface::CONVEX)  ? -surface.deviation(adjacency)
                                                           : 0;
  }

  /// Accounts for an edge by its length and signed deviation.
  void add(double l, double deviation)
  {
    length += l;
    ++number_of_adjacencies;
    if (deviation > 0)
      concave += l * (std::min)(deviation, 0.6);
    else
      convex += l * (std::min)(-deviation, 2.0);
  }
};

/// \ingroup PkgRegionSegmentationGraph
/// Area, thickness and visibility of a region, filled by `Visibility_annotator`. A model of
/// `RegionData`.
struct Visibility_region_data
{
  double area = 0;          ///< share of the area of the surface
  double log_thickness = 0; ///< integral over the area of the logarithm of the thickness
  double visibility = 0;    ///< weight of the ends of rays in the region

  double mean_log_thickness() const { return area > 0 ? log_thickness / area : 0; }

  void add_face(const Surface&, std::size_t /* face */) {}
  void add_border(const Surface&, std::size_t /* adjacency */) {}

  /// Adds the region on the other side of a section.
  void absorb(const Visibility_region_data& other, const Visibility_section_data& /* between */)
  {
    area += other.area;
    log_thickness += other.log_thickness;
    visibility += other.visibility;
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_VISIBILITY_DATA_H
