// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CUT_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CUT_H

#include <CGAL/Region_segmentation/Merge_tree.h>
#include <CGAL/Region_segmentation/internal/companions.h>
#include <CGAL/Region_segmentation/internal/Lowest_root_forest.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The regions split into `number_of_segments`: the faces that came last leave, each with those that came
/// by it. O(F log F).
inline Region_labels split_regions(const Region_labels& regions, std::size_t number_of_segments)
{
  std::vector<Flat_mesh::Index> order(regions.of_face.size());
  std::iota(order.begin(), order.end(), Flat_mesh::Index(0));
  std::sort(order.begin(), order.end(), [&](Flat_mesh::Index a, Flat_mesh::Index b) {
    return regions.lateness[a] != regions.lateness[b] ? regions.lateness[a] < regions.lateness[b]
                                                      : a < b;
  });
  std::size_t to_join = order.size() - (std::min)(number_of_segments, order.size());
  Lowest_root_forest forest(order.size());
  for (Flat_mesh::Index f : order)
    if (to_join > 0 && regions.predecessor[f] != f) {
      forest.unite(f, regions.predecessor[f]);
      --to_join;
    }
  return forest.take_labels();
}

/// The segment of every face, looked up by way of its region: no label is stored a second time.
class Segment_labels
{
public:
  /// When a tree is cut at a number; below its leaves the regions are split, if their maker tells how.
  Segment_labels(const Region_labels& regions, const Merge_tree& tree, std::size_t number_of_segments)
    : m_regions(regions)
  {
    if (number_of_segments > regions.number_of_regions && !regions.predecessor.empty()) {
      m_split = split_regions(regions, number_of_segments);
      m_number = m_split.number_of_regions;
    } else {
      m_merged = tree.cut_at_count(number_of_segments);
      m_number = m_merged.number_of_segments;
    }
  }

  std::size_t number_of_segments() const { return m_number; }
  std::size_t operator()(std::size_t face) const
  {
    return m_split.of_face.empty() ? m_merged.of_region[m_regions.of_face[face]] : m_split.of_face[face];
  }

private:
  const Region_labels& m_regions;
  Merge_tree::Segmentation m_merged;
  Region_labels m_split;
  std::size_t m_number;
};

/// The wanted number of segments, or the one that a chooser finds where none is wanted.
template <typename Companions, typename Pack>
std::size_t choose_number(const Merge_tree& tree, std::size_t wanted, const Pack&)
{
  using Number = internal_np::number_of_segments_t;
  if constexpr (!CGAL::parameters::is_default_parameter<Pack, Number>::value)
    return wanted;
  else {
    using Chooser = typename Companions::NumberChooser;
    static_assert(!std::is_same<Chooser, No_chooser>::value,
                  "segment() with this merging policy needs the named parameter number_of_segments");
    return Chooser()(tree);
  }
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_CUT_H
