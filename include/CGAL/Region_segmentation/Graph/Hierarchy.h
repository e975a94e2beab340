// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_HIERARCHY_H
#define CGAL_REGION_SEGMENTATION_GRAPH_HIERARCHY_H

#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Support/Partition.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationData
/// The seeds of faces or regions: elements with the same seed belong to one segment, elements with
/// different seeds to different ones.
struct Seeds
{
  using Index = Partition::Index;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  std::vector<Index> of;           ///< by element: 0 .. number() - 1, or none
  std::vector<std::size_t> values; ///< the value of each seed in the user's map

  std::size_t number() const { return values.size(); }
  bool empty() const { return values.empty(); }

  /// Makes seeds from the values of a map; -1 of their type stands for no seed.
  template <typename Value>
  static Seeds from_values(const std::vector<Value>& values)
  {
    Seeds seeds;
    seeds.of = internal::number_labels(values, seeds.values);
    return seeds;
  }
};

/// \ingroup PkgRegionSegmentationData
/// What a user asks of a method: the number of segments, and seeds.
struct Request
{
  std::size_t number_of_segments = 0; ///< 0: chosen by the method
  Seeds seeds;                        ///< of the faces
  /// Whether labels will be asked for other numbers, too. A method may leave out what only these
  /// need: with the borders of all numbers, `segment()` takes 1.1 to 1.4 times as long.
  bool needs_all_numbers = true;
};

/// \ingroup PkgRegionSegmentationData
/// The result of a method that merges in one order for all numbers of segments: first regions,
/// their merges, and the number of segments that was given or chosen. It gives the segments for any
/// number, and these segmentations are nested.
class Hierarchy
{
public:
  Hierarchy() = default;
  /// `regions`: the first regions of the faces; `tree`: their merges
  Hierarchy(Partition regions, Merge_tree tree, std::size_t number_of_segments)
    : m_regions(std::move(regions))
    , m_tree(std::move(tree))
    , m_number(number_of_segments)
  {}

  const Partition& regions() const { return m_regions; }
  const Merge_tree& merge_tree() const { return m_tree; }
  std::size_t number_of_segments() const { return m_number; }

  /// The segments of the faces: `number` of them, or the nearest number that there is.
  Partition segments(std::size_t number) const
  {
    return composed(m_regions, m_tree.partition_at_count(number));
  }

private:
  Partition m_regions;
  Merge_tree m_tree;
  std::size_t m_number = 0;
};

/// \ingroup PkgRegionSegmentationData
/// The result of a method whose order of merges depends on the number of segments: a hierarchy for
/// one number. Its merges end at this number. A method that does not merge pairs of regions gives
/// its segments as regions, and no merges.
class Segmentation : public Hierarchy
{
public:
  using Hierarchy::Hierarchy;
};

namespace internal {

/// The hierarchy of regions to which faces were moved: `region_of` gives the region of each face by
/// the numbers of `tree`. Merges of a region without faces are left out.
inline Hierarchy renumbered_hierarchy(const std::vector<Partition::Index>& region_of,
                                      const Merge_tree& tree, std::size_t number_of_segments)
{
  constexpr Partition::Index none = (std::numeric_limits<Partition::Index>::max)();
  Partition regions = Partition::from_labels(region_of);
  // By former number: the lowest of the new numbers in the segment of a region.
  std::vector<Partition::Index> numbers(tree.number_of_regions(), none);
  for (std::size_t f = 0; f < region_of.size(); ++f)
    numbers[region_of[f]] = regions[f];
  Merge_tree renumbered(regions.number_of_parts());
  for (const Merge_tree::Merge& merge : tree.merges()) {
    const auto [kept, removed] = std::minmax({numbers[merge.kept], numbers[merge.removed]});
    if (removed != none)
      renumbered.push_back({kept, removed, merge.cost});
    numbers[merge.kept] = kept;
  }
  return Hierarchy(std::move(regions), std::move(renumbered), number_of_segments);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_HIERARCHY_H
