// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_COMPONENTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_COMPONENTS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The root of an element of a forest, in which a root is its own parent. Halves the path.
template <typename Parents, typename Index>
Index root_in_forest(Parents& parents, Index i)
{
  Index parent = parents[i];
  for (Index above = parents[parent]; above != parent; above = parents[parent]) {
    parents[i] = above;
    i = above;
    parent = parents[i];
  }
  return parent;
}

/// A forest over the faces in which a parent is never above its child: the root of a tree is its
/// lowest face, independently of the order of unions, so the array of parents becomes the array of
/// labels, numbered by first faces.
/// (`boost::disjoint_sets` keeps a second array and any root.)
///
/// Threads may unite concurrently, each within its own range of faces.
class Lowest_root_forest
{
public:
  using Index = Partition::Index;

  explicit Lowest_root_forest(std::size_t size)
    : m_parents(size)
  {
    std::iota(m_parents.begin(), m_parents.end(), Index(0));
  }
  /// `roots`: of the tree of each face
  explicit Lowest_root_forest(Partition::Numbers roots)
    : m_parents(std::move(roots))
  {}

  /// Returns whether they were in different trees.
  bool unite(Index a, Index b)
  {
    a = root(a);
    b = root(b);
    if (a == b)
      return false;
    m_parents[(std::max)(a, b)] = (std::min)(a, b);
    return true;
  }

  /// The lowest face of a tree.
  Index root(Index i) { return root_in_forest(m_parents, i); }

  /// Numbers the trees by their roots. The forest is empty afterwards.
  Partition take_partition()
  {
    Index number = 0;
    for (std::size_t i = 0; i < m_parents.size(); ++i) {
      const Index parent = m_parents[i];
      m_parents[i] = parent == i ? number++ : m_parents[parent];
    }
    return Partition(std::move(m_parents), number);
  }

private:
  Partition::Numbers m_parents;
};

/// The connected components of the faces across the adjacencies with none of the marks `barring`.
/// `marks`: a byte for each adjacency
/// Each thread unites the faces of a range of blocks; adjacencies between two ranges follow at the
/// end.
inline Partition label_components(const Surface& surface, const std::uint8_t* marks,
                                  std::uint8_t barring, const Execution& execution)
{
  using Index = Surface::Index;
  constexpr std::size_t size_of_range = blocks_in_range * block_size;
  const std::size_t size = surface.number_of_faces();
  std::vector<std::vector<Index>> between_ranges(number_of_blocks(size, size_of_range));
  Lowest_root_forest forest(size);
  const auto unite_range = [&](std::size_t range, std::size_t begin, std::size_t end) {
    const std::size_t first_of_range = execution.is_parallel() ? begin : 0;
    const std::size_t past = surface.first_adjacency(end);
    for (std::size_t a = surface.first_adjacency(begin); a < past; ++a) {
      if ((marks[a] & barring) != 0)
        continue;
      if (surface.lower_face(a) >= first_of_range)
        forest.unite(surface.lower_face(a), surface.higher_face(a));
      else
        between_ranges[range].push_back(Index(a));
    }
  };
  for_each_block(execution, size, unite_range, size_of_range);
  for (const auto& adjacencies : between_ranges)
    for (const Index a : adjacencies)
      forest.unite(surface.lower_face(a), surface.higher_face(a));
  return forest.take_partition();
}

/// The connected components of the faces across the adjacencies that `joins(adjacency)`.
inline Partition label_components(const Surface& surface,
                                  const std::function<bool(std::size_t)>& joins,
                                  const Execution& execution)
{
  Large_array<std::uint8_t> is_barred(surface.number_of_adjacencies());
  for_each_index(execution, is_barred.size(), [&](std::size_t a) { is_barred[a] = !joins(a); });
  return label_components(surface, is_barred.data(), 1, execution);
}

/// The connected components across edges.
inline Partition edge_components(const Surface& surface, const Execution& execution)
{
  return label_components(surface, arrays_of(surface).flags.data(), Surface::SEAM | Surface::LINK,
                          execution);
}

/// By part of the faces: the sum of their areas, in their order.
inline std::vector<double> part_areas(const Surface& surface, const Partition& parts)
{
  std::vector<double> areas(parts.number_of_parts());
  for (std::size_t f = 0; f < parts.size(); ++f)
    areas[parts[f]] += surface.area(f);
  return areas;
}

/// Calls `f(part, element)` for all elements of a partition; those of a part in order, by one
/// thread, so that sums are the same in parallel. Each thread first sorts a range of the elements
/// by ranges of parts, then has one of these.
///
/// \tparam Parts a `Partition` or a `Composed_partition`
template <typename Parts, typename F>
void for_each_in_part(const Execution& execution, const Parts& parts, const F& f)
{
  const std::size_t ranges = execution.number_of_threads();
  if (ranges == 1) {
    for (std::size_t i = 0; i < parts.size(); ++i)
      f(parts[i], i);
    return;
  }
  using Index = Partition::Index;
  const std::size_t size = number_of_blocks(parts.size(), ranges),
                    number = number_of_blocks(parts.number_of_parts(), ranges); // in a range
  std::vector<Grouped_items<Index>> elements(ranges);
  execution.for_each(0, ranges, [&](std::size_t range) {
    const std::size_t end = (std::min)((range + 1) * size, parts.size());
    elements[range] = Grouped_items<Index>(ranges, [&](const auto& add) {
      for (std::size_t i = range * size; i < end; ++i)
        add(parts[i] / number, Index(i));
    });
  });
  execution.for_each(0, ranges, [&](std::size_t range_of_parts) {
    for (const Grouped_items<Index>& of_range : elements)
      for (const Index i : of_range[range_of_parts])
        f(parts[i], i);
  });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_COMPONENTS_H
