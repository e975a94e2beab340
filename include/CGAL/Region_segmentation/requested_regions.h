// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_REQUESTED_REGIONS_H
#define CGAL_REGION_SEGMENTATION_REQUESTED_REGIONS_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/graph/merge_graph.h>
#include <CGAL/Region_segmentation/internal/regions/apply_seeds.h>
#include <CGAL/Region_segmentation/internal/surface/find_crumbs.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationData
/// First regions as seeds change them, and the seeds of regions.
struct Requested_regions
{
  Partition regions; ///< of the faces
  Seeds seeds;       ///< of the regions

  bool is_fixed(Partition::Index region) const
  {
    return !seeds.empty() && seeds.of[region] != Seeds::none;
  }
};

/// \ingroup PkgRegionSegmentationData
/// splits regions that have faces of several seeds, and joins regions of equal seeds along the
/// cheapest path.
/// \throws Invalid_input if the faces of a seed cannot be joined, Invalid_method if `regions` is no
///         partition of the faces
inline Requested_regions requested_regions(const Surface& surface, const Partition& regions,
                                           const Seeds& seeds)
{
  internal::check_regions(regions, surface.number_of_faces());
  if (seeds.empty())
    return {regions, Seeds()};
  Requested_regions result{internal::apply_seeds(surface, regions, seeds), Seeds()};
  result.seeds = internal::seeds_of_regions(result.regions, seeds);
  return result;
}

/// \ingroup PkgRegionSegmentationData
/// merges the graph of requested regions by a policy until `number` are left: regions of different
/// seeds never, crumbs first.
///
/// \tparam Graph a `Region_adjacency_graph` of `requested.regions`
/// \tparam Policy a model of `MergingPolicy`, or `Policy_phases`
/// \param surface that of the regions
/// \param requested the regions, which seeds and constraints have changed
/// \param graph is merged
/// \param policy determines the order of merges
/// \param number of regions to be left; with 1 there is a tree for all numbers
/// \param execution `Execution()`, or the stage of the merges (`execution.stage("merging")`)
/// \returns the tree of the merges
template <typename Graph, typename Policy>
Merge_tree merge_requested_regions(const Surface& surface, const Requested_regions& requested,
                                   Graph& graph, Policy policy, std::size_t number,
                                   const Execution& execution)
{
  auto of_crumbs = internal::merges_of_crumbs(surface, requested.regions);
  of_crumbs.erase(std::remove_if(of_crumbs.begin(), of_crumbs.end(),
                                 [&](const auto& pair) { return requested.is_fixed(pair.first); }),
                  of_crumbs.end());
  internal::Merger<Graph> merger(graph, requested.seeds, number, execution);
  merger.merge_first(of_crumbs);
  merger.run(policy);
  return merger.take_tree();
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_REQUESTED_REGIONS_H
