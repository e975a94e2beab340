// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CUT_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CUT_H

#include <CGAL/Region_segmentation/Merge_tree.h>
#include <CGAL/Region_segmentation/internal/companions.h>
#include <CGAL/Region_segmentation/internal/Lowest_root_forest.h>
#include <CGAL/Region_segmentation/internal/blocks.h>

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
  Lowest_root_forest<> forest(order.size());
  for (Flat_mesh::Index f : order)
    if (to_join > 0 && regions.predecessor[f] != f) {
      forest.unite(f, regions.predecessor[f]);
      --to_join;
    }
  return forest.take_labels();
}

/// The segments of the faces when a tree is cut at a number; below its leaves the regions are split, if
/// their maker tells how.
template <typename ConcurrencyTag>
Region_labels cut(const Region_labels& regions, const Merge_tree& tree,
                         std::size_t number_of_segments)
{
  if (number_of_segments > regions.number_of_regions && !regions.predecessor.empty())
    return split_regions(regions, number_of_segments);
  const Merge_tree::Segmentation segments = tree.cut_at_count(number_of_segments);
  Region_labels result;
  result.number_of_regions = segments.number_of_segments;
  result.of_face.resize(regions.of_face.size());
  for_each_block<ConcurrencyTag>(
    result.of_face.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f)
        result.of_face[f] = segments.of_region[regions.of_face[f]];
    });
  return result;
}

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
