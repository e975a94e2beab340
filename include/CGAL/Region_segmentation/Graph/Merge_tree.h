// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_MERGE_TREE_H
#define CGAL_REGION_SEGMENTATION_GRAPH_MERGE_TREE_H

#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/exceptions.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationGraph
/// The merges of a run, in order. The first m merges define a partition of the regions into
/// segments, for each m. These partitions are nested: each segment lies in one segment of the
/// partition after more merges.
class Merge_tree
{
public:
  /// One merge. The region that is kept is the lower one of two ids.
  struct Merge
  {
    std::uint32_t kept, removed; ///< first regions; `kept` is the id of the merged region, too
    double cost;                 ///< the cost that the policy gives, in its units
  };

  /// The cost of the merges of crumbs, which are made before those of a policy.
  static constexpr double least_cost = std::numeric_limits<double>::lowest();

  /// Makes a tree without merges.
  explicit Merge_tree(std::size_t number_of_regions = 0)
    : m_is_removed(number_of_regions)
  {}

  /// The number of first regions.
  std::size_t number_of_regions() const { return m_is_removed.size(); }
  /// The merges, in order. After m merges there are `number_of_regions()` - m segments.
  const std::vector<Merge>& merges() const& { return m_merges; }
  std::vector<Merge> merges() && { return std::move(m_merges); }

  /// \throws Invalid_method in every build, unless `kept < removed < number_of_regions()` and
  ///         neither region was removed before
  void push_back(const Merge& merge)
  {
    if (merge.kept >= merge.removed || merge.removed >= number_of_regions() ||
        m_is_removed[merge.kept] || m_is_removed[merge.removed])
      throw Invalid_method("a Merge_tree of " + std::to_string(number_of_regions()) +
                           " regions cannot merge region " + std::to_string(merge.removed) +
                           " into region " + std::to_string(merge.kept));
    m_is_removed[merge.removed] = true;
    m_merges.push_back(merge);
  }

  /// The partition into `number_of_segments`, or the nearest number that the tree has: at most the
  /// number of regions, at least the number of regions less the number of merges. O(R).
  Partition partition_at_count(std::size_t number_of_segments) const
  {
    const std::size_t wanted = number_of_segments < number_of_regions()
                                 ? number_of_regions() - number_of_segments
                                 : 0;
    internal::Lowest_root_forest segments(number_of_regions());
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
    return number_of_regions() - std::size_t(first_above - m_merges.begin());
  }

  /// The partition into `number_at_cost(maximum_cost)` segments. O(R).
  Partition partition_at_cost(double maximum_cost) const
  {
    return partition_at_count(number_at_cost(maximum_cost));
  }

private:
  std::vector<bool> m_is_removed; // by region
  std::vector<Merge> m_merges;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_MERGE_TREE_H
