// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_MERGE_CANDIDATE_H
#define CGAL_REGION_SEGMENTATION_GRAPH_MERGE_CANDIDATE_H

#include <CGAL/Region_segmentation/Graph/Section_descriptor.h>

#include <cstddef>
#include <tuple>
#include <utility>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// The section across which a policy proposes to merge next, and its cost in the units of the
/// policy.
struct Merge_candidate
{
  Section_descriptor section;
  double cost; ///< a number, possibly infinite
};

/// \ingroup PkgRegionSegmentationPolicies
/// Policies one after the other, each with the number of regions at which the next one takes over:
/// what merges by a policy takes these, too. Where a policy has no further candidate before,
/// merging ends.
///
/// \code
/// RS::merge_regions(graph, RS::Policy_phases<RS::Smallest_region_first, My_policy>{
///                            {RS::Smallest_region_first(), 100}, {My_policy(), 1}}, 8);
/// \endcode
///
/// \tparam Policies models of `MergingPolicy`
template <typename... Policies>
using Policy_phases = std::tuple<std::pair<Policies, std::size_t>...>;

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_MERGE_CANDIDATE_H
