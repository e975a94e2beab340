// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_SCALAR_COST_H
#define CGAL_REGION_SEGMENTATION_METHODS_SCALAR_COST_H

#include <CGAL/Region_segmentation/Methods/Scalar_annotator.h>
#include <CGAL/Region_segmentation/Methods/Visibility_cost.h>

#include <cmath>
#include <utility>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// Another cost, and the difference of the mean scalars of the two regions, times a weight. A model
/// of `SectionCost`, for graphs annotated by `Scalar_annotator`.
///
/// \tparam Cost the other cost, a model of `SectionCost` that names its data
template <typename Cost = Visibility_cost>
struct Scalar_cost
{
  using RegionData = Scalar_region_data<typename Cost::RegionData>;
  using SectionData = typename Cost::SectionData;

  double weight; ///< what a difference of 1 costs, in the units of `cost`. Of `Visibility_cost`, 2
                 ///< is much
  Cost cost;

  explicit Scalar_cost(double weight_ = 1, Cost cost_ = Cost())
    : weight(weight_)
    , cost(std::move(cost_))
  {}

  template <typename Graph>
  double operator()(const Graph& graph, typename Graph::section_descriptor s) const
  {
    return cost(graph, s) + weight * std::abs(graph[graph.source(s)].mean_scalar() -
                                              graph[graph.target(s)].mean_scalar());
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_SCALAR_COST_H
