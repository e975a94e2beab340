// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_BOX_TREE_BUILDER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_BOX_TREE_BUILDER_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/rays/Box_partition.h>
#include <CGAL/Region_segmentation/internal/rays/Float_4.h>
#include <CGAL/Region_segmentation/internal/rays/Four_triangles.h>
#include <CGAL/Region_segmentation/internal/support/blocks.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A node of a tree of boxes.
struct Box_node
{
  static constexpr std::size_t width = 4; ///< most children: their boxes are tested together
  /// Twice the index of a node, or twice that of a leaf plus one.
  using Child = std::uint32_t;

  std::array<Float_4_3, 2> bounds; ///< of the children, lower and upper ones; reversed for missing children
  /// Missing ones are the first leaf: no bound holds back a ray that is not a number, and no way must lead upwards.
  std::array<Child, width> child = {1, 1, 1, 1};
};

/// Builds a tree of boxes. One thread splits them into parts of up to `boxes_of_a_job`, from which threads build subtrees.
class Box_tree_builder
{
  using Node = Box_node;
  using Child = Node::Child;
  using Range = Box_partition::Range;
  using Part = Box_partition::Part;

public:
  /// Below the cheap splits are halves, of at most 2^32 boxes.
  static constexpr int maximum_depth = 48 + 32;

  /// `boxes`: are reordered. `leaves_are_boxes`: each box is a leaf, and its name the index of the leaf; else leaves are ranges of up to
  /// `Box_node::width` boxes
  /// \pre there are boxes
  template <typename ConcurrencyTag>
  Box_tree_builder(Box_partition& boxes, bool leaves_are_boxes, const Execution<ConcurrencyTag>& execution)
    : m_boxes(boxes), m_leaf_size(leaves_are_boxes ? 1 : Node::width)
  {
    std::vector<Job> jobs;
    add_node(boxes.whole(), 0, m_tree, &jobs);
    const auto run = [&](std::size_t i, std::size_t, std::size_t) { add_node(jobs[i].part, jobs[i].depth, jobs[i].tree, nullptr); };
    for_each_block(execution, jobs.size(), run, 1);
    for (const Job& job : jobs)
      m_tree.nodes[job.parent].child[job.position] = append(job.tree);
  }

  /// The root is the first.
  std::vector<Node> take_nodes() { return std::move(m_tree.nodes); }
  /// Unless they are boxes.
  std::vector<Range> take_leaves() { return std::move(m_tree.leaves); }

private:
  static constexpr std::size_t boxes_of_a_job = 4096;
  static constexpr int maximum_depth_of_cheap_splits = maximum_depth - 32;
  static constexpr std::size_t width = Node::width;
  static_assert(width == Box_partition::leaf_size, "parts of this size are not split");

  /// Children are numbered within it.
  struct Tree
  {
    std::vector<Node> nodes;
    std::vector<Range> leaves;
  };

  /// A subtree to be built.
  struct Job
  {
    Part part;
    int depth;
    std::size_t parent, position; // among its children
    Tree tree;
  };

  /// Adds a subtree; returns its root.
  Child append(const Tree& tree)
  {
    const Child first_node = Child(2 * m_tree.nodes.size()), first_leaf = Child(2 * m_tree.leaves.size());
    for (Node node : tree.nodes) {
      for (Child& child : node.child)
        child += child % 2 == 0 ? first_node : first_leaf;
      m_tree.nodes.push_back(node);
    }
    m_tree.leaves.insert(m_tree.leaves.end(), tree.leaves.begin(), tree.leaves.end());
    return first_node;
  }

  /// Adds a node for a part, and its descendants; those of few boxes become jobs, if these are wanted.
  Child add_node(const Part& part, int depth, Tree& tree, std::vector<Job>* jobs) const
  {
    std::array<Part, width> parts{};
    const std::size_t size = split(part, depth, parts);
    const std::size_t n = tree.nodes.size();
    tree.nodes.emplace_back();
    for (std::size_t i = 0; i < width; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        tree.nodes[n].bounds[0][k][i] = parts[i].box.low[k];
        tree.nodes[n].bounds[1][k][i] = parts[i].box.high[k];
      }
    for (std::size_t i = 0; i < size; ++i)
      if (parts[i].size() <= m_leaf_size)
        tree.nodes[n].child[i] = add_leaf(parts[i], tree);
      else if (jobs && parts[i].size() <= boxes_of_a_job)
        jobs->push_back({parts[i], depth + 1, n, i, {}});
      else {
        const Child child = add_node(parts[i], depth + 1, tree, jobs);
        tree.nodes[n].child[i] = child;
      }
    return Child(2 * n);
  }

  Child add_leaf(const Part& part, Tree& tree) const
  {
    if (m_leaf_size == 1)
      return Child(2 * m_boxes.name(part.first) + 1);
    tree.leaves.push_back(part);
    return Child(2 * tree.leaves.size() - 1);
  }

  /// Splits a part for the children of a node; returns their number.
  std::size_t split(const Part& part, int depth, std::array<Part, width>& parts) const
  {
    std::size_t size = 0;
    if (m_leaf_size == 1 && part.size() <= width) {
      for (; size < part.size(); ++size)
        parts[size] = m_boxes.single(part.first + size);
      return size;
    }
    for (parts[size++] = part; size < width; ++size) {
      const auto largest = std::max_element(parts.begin(), parts.begin() + std::ptrdiff_t(size), [](const Part& a, const Part& b) {
        return area_to_split(a) < area_to_split(b);
      });
      if (largest->size() <= width)
        break;
      std::tie(*largest, parts[size]) =
        depth < maximum_depth_of_cheap_splits ? m_boxes.split(*largest) : m_boxes.split_at_median(*largest);
    }
    return size;
  }

  static float area_to_split(const Part& part) { return part.size() > width ? part.box.half_area() : -1; }

  Box_partition& m_boxes;
  const std::size_t m_leaf_size;
  Tree m_tree;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_BOX_TREE_BUILDER_H
