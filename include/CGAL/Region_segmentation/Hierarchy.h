// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_HIERARCHY_H
#define CGAL_REGION_SEGMENTATION_HIERARCHY_H

#include <CGAL/Region_segmentation/Graph/Merge_tree.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>

#include <cstddef>
#include <limits>
#include <memory>
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
  std::vector<std::size_t> values; ///< of the user's map, by seed

  std::size_t number() const { return values.size(); }
  bool empty() const { return values.empty(); }

  /// From the values of a map; -1 of their type stands for none.
  template <typename Value>
  static Seeds from_values(const std::vector<Value>& values)
  {
    Seeds seeds;
    seeds.of = internal::number_labels(values, seeds.values);
    return seeds;
  }
};

/// \ingroup PkgRegionSegmentationData
/// What a user wants of a segmentation, beyond the method.
struct Request
{
  /// The numbers of segments for which labels will be asked.
  enum class Numbers { ALL, ONE };

  std::size_t number_of_segments = 0; ///< 0: chosen by the method
  Numbers numbers = Numbers::ALL; ///< `ONE`: a method may leave out what only other numbers need
  Seeds seeds;                    ///< of the faces
};

/// \ingroup PkgRegionSegmentationData
/// What a method gives whose order of merges does not depend on the number of segments: first
/// regions, their merges, and the number of segments that was given or chosen. Any number of
/// segments is at hand, and the segmentations are nested. Copies share the first regions.
class Hierarchy
{
public:
  Hierarchy() = default;
  /// `regions`: of the faces; `tree`: their merges
  Hierarchy(Partition regions, Merge_tree tree, std::size_t number_of_segments)
    : m_regions(std::make_shared<const Partition>(std::move(regions)))
    , m_tree(std::move(tree))
    , m_number(number_of_segments)
  {}

  const Partition& regions() const { return *m_regions; }
  const Merge_tree& merge_tree() const { return m_tree; }
  std::size_t number_of_segments() const { return m_number; }

  /// The segments of the faces: `number` of them, or the nearest number that there is.
  Composed_partition segments(const Surface&, std::size_t number) const
  {
    return Composed_partition(m_regions, m_tree.partition_at_count(number));
  }

private:
  std::shared_ptr<const Partition> m_regions = std::make_shared<const Partition>();
  Merge_tree m_tree;
  std::size_t m_number = 0;
};

/// \ingroup PkgRegionSegmentationData
/// What a method gives whose order of merges depends on the number of segments: a hierarchy for one
/// number alone. Its merges end there; if regions were not merged one pair at a time, the segments
/// are its regions, and it has no merges.
class Segmentation : public Hierarchy
{
public:
  using Hierarchy::Hierarchy;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_HIERARCHY_H
