// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_MERGE_TREE_H
#define CGAL_REGION_SEGMENTATION_GRAPH_MERGE_TREE_H

#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationGraph
/// The merges of a run, in order. Any number of them defines a partition of the regions into
/// segments. Partitions are nested: a segment after fewer merges lies in one segment after more.
class Merge_tree
{
public:
  /// One merge. The region that is kept is the lower one of two ids.
  struct Merge
  {
    std::uint32_t kept, removed; ///< first regions; `kept` stands for the merged region from here
                                 ///< on
    double cost;                 ///< as its policy gave it; in the units of the policy
  };

  /// The cost of merges that come before those of a policy: of crumbs.
  static constexpr double least_cost = std::numeric_limits<double>::lowest();

  /// Makes a tree without merges.
  explicit Merge_tree(std::size_t number_of_regions = 0)
    : m_number_of_regions(number_of_regions)
  {}

  /// The number of first regions.
  std::size_t number_of_regions() const { return m_number_of_regions; }
  /// The merges in the order in which they were made. After `m` of them there are
  /// `number_of_regions() - m` segments.
  const std::vector<Merge>& merges() const& { return m_merges; }
  std::vector<Merge> merges() && { return std::move(m_merges); }

  /// \pre `kept < removed < number_of_regions()`, and neither was removed before
  void push_back(const Merge& merge)
  {
    CGAL_precondition(merge.kept < merge.removed && merge.removed < m_number_of_regions);
    m_merges.push_back(merge);
  }

  /// The partition into `number_of_segments`, or the nearest number that the tree has: at most the
  /// number of regions, at least the number of regions less the number of merges. O(R).
  Partition partition_at_count(std::size_t number_of_segments) const
  {
    const std::size_t wanted = number_of_segments < m_number_of_regions
                                 ? m_number_of_regions - number_of_segments
                                 : 0;
    internal::Lowest_root_forest segments(m_number_of_regions);
    for (std::size_t i = 0; i < (std::min)(wanted, m_merges.size()); ++i)
      segments.unite(m_merges[i].kept, m_merges[i].removed);
    return segments.take_partition();
  }

  /// The number of segments before the first merge that costs more than `maximum_cost`. O(R).
  std::size_t number_at_cost(double maximum_cost) const
  {
    const auto first_above = std::find_if(
      m_merges.begin(), m_merges.end(),
      [maximum_cost](const Merge& m) { return m.cost > maximum_cost; });
    return m_number_of_regions - std::size_t(first_above - m_merges.begin());
  }

  /// The partition into `number_at_cost(maximum_cost)` segments. O(R).
  Partition partition_at_cost(double maximum_cost) const
  {
    return partition_at_count(number_at_cost(maximum_cost));
  }

private:
  std::size_t m_number_of_regions;
  std::vector<Merge> m_merges;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_MERGE_TREE_H
