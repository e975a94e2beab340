// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_COMPONENTS_H
#define CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_COMPONENTS_H

#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The root of an element of a forest, in which a root is its own parent. The path to the root is
/// halved.
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

/// A forest over elements, such as faces, in which a parent is never above its child: the root of a
/// tree is its lowest element, independently of the order of unions, so the array of parents
/// becomes the array of labels, numbered by first elements.
/// (`boost::disjoint_sets` keeps a second array, and its roots depend on the order of unions.)
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
  /// Makes a forest of existing trees: `roots[f]` is the root of element f.
  explicit Lowest_root_forest(Partition::Numbers roots)
    : m_parents(std::move(roots))
  {}

  /// Unites the trees of two elements. Returns whether these were different.
  bool unite(Index a, Index b)
  {
    a = root(a);
    b = root(b);
    if (a == b)
      return false;
    m_parents[(std::max)(a, b)] = (std::min)(a, b);
    return true;
  }

  /// The lowest element of the tree of an element.
  Index root(Index i) { return root_in_forest(m_parents, i); }

  /// The trees as parts. The forest is empty afterwards.
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

/// The connected components of the faces across the adjacencies without a mark that is in
/// `barring`. Each thread unites the faces of a range of blocks; adjacencies between two ranges
/// are united sequentially afterwards.
/// `marks`: a byte for each adjacency
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

/// The connected components of the faces across the adjacencies for which `joins(adjacency)` is
/// true.
inline Partition label_components(const Surface& surface,
                                  const std::function<bool(std::size_t)>& joins,
                                  const Execution& execution)
{
  Large_array<std::uint8_t> is_barred(surface.number_of_adjacencies());
  for_each_index(execution, is_barred.size(), [&](std::size_t a) { is_barred[a] = !joins(a); });
  return label_components(surface, is_barred.data(), 1, execution);
}

/// The area of each part of the faces: the sum of the areas of its faces, in their order.
inline std::vector<double> part_areas(const Surface& surface, const Partition& parts)
{
  std::vector<double> areas(parts.number_of_parts());
  for (std::size_t f = 0; f < parts.size(); ++f)
    areas[parts[f]] += surface.area(f);
  return areas;
}

/// Dijkstra's algorithm from several sources, for a graph that is given by the steps from each
/// node. Nodes at the same distance are visited by index.
///
/// `distances`: by node; infinite, or a bound: a node is entered below it.
/// `visit(node)`: called for each node that is reached, when its distance is final; returns whether
/// to go on. `for_each_step(node, enter)`: calls `enter(neighbor, length)` for the steps
/// from a node, which returns whether the neighbor became nearer. A step of negative
/// length that gives a node the distance 0 makes it a source, which is visited again.
template <typename Index, typename Visit, typename ForEachStep>
void find_shortest_paths(const std::vector<Index>& sources, std::vector<double>& distances,
                         const Visit& visit, const ForEachStep& for_each_step)
{
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> front;
  for (const Index source : sources)
    if (distances[source] > 0) { // so that a source that is given twice is visited once
      distances[source] = 0;
      front.push({0, source});
    }
  while (!front.empty()) {
    const auto [distance, node] = front.top();
    front.pop();
    if (distance > distances[node]) // a shorter path was found later
      continue;
    if (!visit(node))
      return;
    for_each_step(node, [&, from = distance](Index neighbor, double length) {
      const double longer = from + length;
      if (!(longer < distances[neighbor]))
        return false;
      distances[neighbor] = longer;
      front.push({longer, neighbor});
      return true;
    });
  }
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_COMPONENTS_H
