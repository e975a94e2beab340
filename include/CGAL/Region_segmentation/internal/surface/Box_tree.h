// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_BOX_TREE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_BOX_TREE_H

#include <CGAL/Region_segmentation/internal/surface/Axis_box.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A balanced binary tree of boxes. A leaf has one item; a node is divided at the median of the
/// centers of its items, along the axis where these are farthest from each other. Building takes
/// O(n log n).
///
/// Nodes are numbered from the root, 0: a node, what is below its first child, what is below its
/// second child.
///
/// Bytes: 64 per item.
class Box_tree
{
public:
  using Index = std::uint32_t;

  /// Of the items 0 to `size - 1` with the boxes `box_of(item)`.
  template <typename BoxOf>
  Box_tree(std::size_t size, const BoxOf& box_of)
  {
    std::vector<Node> leaves;
    leaves.reserve(size);
    for (Index i = 0; i < size; ++i)
      leaves.push_back({box_of(i), 0, i});
    m_nodes.reserve(2 * size);
    if (size > 0)
      add(leaves.begin(), leaves.end());
  }

  std::size_t number_of_nodes() const { return m_nodes.size(); }
  const Axis_box& box(Index node) const { return m_nodes[node].box; }
  bool is_leaf(Index node) const { return m_nodes[node].past == node + 1; }
  /// \pre the node is a leaf
  Index item(Index node) const { return m_nodes[node].item; }
  /// \pre the node is no leaf
  std::pair<Index, Index> children(Index node) const { return {node + 1, m_nodes[node + 1].past}; }

  /// A value for each node: `of_leaf(leaf)`, `combine(value, value)` of others.
  template <typename OfLeaf, typename Combine>
  auto values(const OfLeaf& of_leaf, const Combine& combine) const
  {
    std::vector<decltype(of_leaf(Index()))> result(m_nodes.size());
    for (Index node = Index(m_nodes.size()); node-- > 0;)
      result[node] = is_leaf(node) ? of_leaf(node)
                                   : combine(result[node + 1], result[m_nodes[node + 1].past]);
    return result;
  }

  /// Calls `f(node)` for the nodes that are `wanted(node)` and below none that is.
  template <typename Wanted, typename F>
  void for_each_topmost(const Wanted& wanted, const F& f) const
  {
    for (Index node = 0; node < m_nodes.size();) {
      const bool is_wanted = wanted(node);
      if (is_wanted)
        f(node);
      node = is_wanted ? m_nodes[node].past : node + 1;
    }
  }

  /// Calls `f(leaf)` for the leaves in nodes with `key(node) < bound`, which `f` may lower; below
  /// the child of lower key first.
  template <typename Key, typename F>
  void search(const Key& key, const double& bound, const F& f, Index node = 0) const
  {
    if (is_leaf(node))
      return f(node);
    auto [first, second] = children(node);
    double first_key = key(first), second_key = key(second);
    if (second_key < first_key) {
      std::swap(first, second);
      std::swap(first_key, second_key);
    }
    if (first_key < bound)
      search(key, bound, f, first);
    if (second_key < bound)
      search(key, bound, f, second);
  }

  /// Calls `f(leaf, other)` for the pairs of leaves below `a` and `b`, but those below nodes with
  /// `is_left_out(node, other)`; below the nearer child first.
  template <typename IsLeftOut, typename F>
  void for_each_pair(Index a, Index b, const IsLeftOut& is_left_out, const F& f) const
  {
    if (is_left_out(a, b))
      return;
    if (is_leaf(a) && is_leaf(b))
      return f(a, b);
    const bool divides_first = is_leaf(b) || (!is_leaf(a) && longest(a) >= longest(b));
    auto [first, second] = children(divides_first ? a : b);
    const Axis_box& other = box(divides_first ? b : a);
    if (squared_distance_of_centers(box(second), other) <
        squared_distance_of_centers(box(first), other))
      std::swap(first, second);
    for (const Index child : {first, second})
      for_each_pair(divides_first ? child : a, divides_first ? b : child, is_left_out, f);
  }

private:
  struct Node
  {
    Axis_box box;
    Index past; ///< all that is below
    Index item; ///< of a leaf
  };
  using Iterator = std::vector<Node>::iterator;

  double longest(Index node) const { return box(node).extent(box(node).longest_axis()); }

  /// Adds the node of these leaves, and what is below it.
  void add(Iterator begin, Iterator end)
  {
    const std::size_t node = m_nodes.size();
    m_nodes.push_back({begin->box, Index(node + 1), begin->item});
    if (end - begin == 1)
      return;
    Axis_box centers;
    for (Iterator i = begin; i != end; ++i)
      centers.add_point({i->box.center(0), i->box.center(1), i->box.center(2)});
    const std::size_t axis = centers.longest_axis();
    const Iterator median = begin + (end - begin) / 2;
    std::nth_element(begin, median, end, [&](const Node& a, const Node& b) {
      return std::make_pair(a.box.center(axis), a.item) <
             std::make_pair(b.box.center(axis), b.item);
    });
    add(begin, median);
    const std::size_t second = m_nodes.size();
    add(median, end);
    m_nodes[node].box = m_nodes[node + 1].box;
    m_nodes[node].box.add(m_nodes[second].box);
    m_nodes[node].past = Index(m_nodes.size());
  }

  std::vector<Node> m_nodes;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_BOX_TREE_H
