// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CONCEPTS_CHECK_ANNOTATOR_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CONCEPTS_CHECK_ANNOTATOR_H

#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/concepts/check_graph_data.h>
#include <CGAL/Region_segmentation/internal/support/satisfies.h>

#include <type_traits>

namespace CGAL {
namespace Region_segmentation {

class Region_rays;

namespace internal {

template <typename T>
constexpr bool check_annotator()
{
  static_assert(satisfies<Names_data, T>,
                "a GraphAnnotator needs the nested types RegionData and SectionData");
  if constexpr (satisfies<Names_data, T>)
    static_assert(
      std::is_invocable<const T&,
                        Region_adjacency_graph<typename T::RegionData, typename T::SectionData>&,
                        const Surface&, const Partition&, const Region_rays&>::value,
      "a GraphAnnotator needs: void operator()(Graph&, const Surface&, const Partition& regions, "
      "const Region_rays&) const");
  return true;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_CONCEPTS_CHECK_ANNOTATOR_H
