// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_CUT_COST_H
#define CGAL_REGION_SEGMENTATION_CUT_COST_H

#include <CGAL/Region_segmentation/part_and_cut_data.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// What a cut along a section is worth. A model of `SectionCost`.
struct Cut_cost
{
  using RegionData = Part_data;
  using SectionData = Cut_data;

  double depth_exponent = 3.83, depth_offset = 0.0233;
  double area_exponent = 1.74, harmonic_share = 0.13;
  double length_exponent = 0.873;
  double thickness_exponent = 1, thickness_offset = 0.168;
  double sight_exponent = 0.215, sight_offset = 0.012;
  double convex_weight = 0.293, bend_weight = 0.065;

  /// The constants while regions are many and small: what sees each other belongs together.
  static Cut_cost for_many_regions()
  {
    Cut_cost cost;
    cost.depth_exponent = 3.14;
    cost.depth_offset = 0.053;
    cost.area_exponent = 1.24;
    cost.thickness_exponent = 0.78;
    cost.sight_exponent = 0.486;
    return cost;
  }

  template <typename Graph>
  double operator()(const Graph& graph, typename Graph::section_descriptor s) const
  {
    const Cut_data& cut = graph[s];
    if (cut.number_of_edges == 0)
      return std::numeric_limits<double>::quiet_NaN();
    const Part_data &a = graph[graph.source(s)], &b = graph[graph.target(s)];
    const double length = (std::max)(cut.length, smallest);
    const double depth =
      (std::max)(0.0, (cut.concave - convex_weight * cut.convex + bend_weight * cut.bend) / length) +
      depth_offset;
    const double smaller = (std::max)((std::min)(a.area, b.area), smallest);
    const double larger = (std::max)((std::max)(a.area, b.area), smallest);
    const double harmonic = 2 * smaller * larger / (smaller + larger);
    const double seen = (std::min)(a.sight, b.sight);
    const double sight = seen > 0 ? cut.sight / seen : 0;
    return depth_exponent * std::log(depth) +
           area_exponent *
             ((1 - harmonic_share) * std::log(smaller) + harmonic_share * std::log(harmonic)) -
           length_exponent * (2 * std::log(length) - std::log(smaller)) +
           thickness_exponent *
             std::log(thickness_offset + std::abs(a.mean_thickness() - b.mean_thickness())) -
           sight_exponent * std::log(sight_offset + sight);
  }

private:
  static constexpr double smallest = 1e-12; // relative lengths and areas below it count as this one
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_CUT_COST_H
