// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_USER_METHOD_H
#define CGAL_REGION_SEGMENTATION_TEST_USER_METHOD_H

// A method as a user writes it, of public functions alone.

#include <CGAL/Region_segmentation/Graph/Hierarchy.h>
#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Graph/merge_regions.h>
#include <CGAL/Region_segmentation/Graph/requested_regions.h>
#include <CGAL/Region_segmentation/Two_step/Two_step.h>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace test {

/// First regions: every face.
struct Single_faces
{
  CGAL::Region_segmentation::Partition
  operator()(const CGAL::Region_segmentation::Surface& surface) const
  {
    std::vector<CGAL::Region_segmentation::Partition::Index> numbers(surface.number_of_faces());
    std::iota(numbers.begin(), numbers.end(), CGAL::Region_segmentation::Partition::Index(0));
    return CGAL::Region_segmentation::Partition(numbers, numbers.size());
  }
};

/// Regions made by one function object and merged by a policy, with the geometry of regions. It
/// takes constraints; of seeds, it only parts and joins first regions.
template <typename Initializer, typename Policy>
struct User_method
{
  Initializer initializer;
  Policy policy;
  std::size_t chosen_number = 2;

  CGAL::Region_segmentation::Partition prepare(const CGAL::Region_segmentation::Surface& surface,
                                               std::size_t /* number_of_segments */,
                                               const CGAL::Region_segmentation::Execution&) const
  {
    return initializer(surface);
  }

  CGAL::Region_segmentation::Hierarchy
  merge(const CGAL::Region_segmentation::Surface& surface,
        const CGAL::Region_segmentation::Partition& prepared,
        const CGAL::Region_segmentation::Request& request,
        const CGAL::Region_segmentation::Execution& execution) const
  {
    namespace RS = CGAL::Region_segmentation;
    RS::Requested_regions requested = RS::requested_regions(surface, prepared, request.seeds);
    auto graph = RS::build_region_adjacency_graph(surface, requested.regions, execution);
    const std::size_t number = request.number_of_segments > 0 ? request.number_of_segments
                                                              : chosen_number;
    RS::Merge_tree tree = RS::merge_regions(graph, policy, 1);
    return RS::Hierarchy(std::move(requested.regions), std::move(tree), number);
  }
};

template <typename Initializer, typename Policy>
User_method<Initializer, Policy> make_user_method(Initializer initializer, Policy policy)
{
  return {std::move(initializer), std::move(policy)};
}

} // namespace test

#endif // CGAL_REGION_SEGMENTATION_TEST_USER_METHOD_H
