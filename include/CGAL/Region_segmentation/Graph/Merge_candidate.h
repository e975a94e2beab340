// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_MERGE_CANDIDATE_H
#define CGAL_REGION_SEGMENTATION_GRAPH_MERGE_CANDIDATE_H

#include <CGAL/Region_segmentation/Graph/Section_descriptor.h>

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

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_MERGE_CANDIDATE_H
