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
  /// Twice the index of a node, or twice the name of a box plus one: a leaf.
  using Child = std::uint32_t;

  std::array<Float_4_3, 2> bounds; ///< of the children, lower and upper ones; reversed for missing children
  /// Missing ones are box 0: no bound holds back a ray that is not a number, and no way must lead upwards.
  std::array<Child, width> child = {1, 1, 1, 1};
};

/// Builds a tree whose leaves are boxes. One thread splits them into parts of up to `boxes_of_a_job`, from which threads build subtrees.
class Box_tree_builder
{
  using Node = Box_node;
  using Child = Node::Child;
  using Part = Box_partition::Part;

public:
  /// Below the cheap splits are halves, of at most 2^32 boxes.
  static constexpr int maximum_depth = 48 + 32;

  /// `boxes`: are reordered
  /// \pre there are boxes
  template <typename ConcurrencyTag>
  Box_tree_builder(Box_partition& boxes, const Execution<ConcurrencyTag>& execution) : m_boxes(boxes)
  {
    std::vector<Job> jobs;
    add_node(boxes.whole(), 0, m_nodes, &jobs);
    const auto run = [&](std::size_t i, std::size_t, std::size_t) { add_node(jobs[i].part, jobs[i].depth, jobs[i].nodes, nullptr); };
    for_each_block(execution, jobs.size(), run, 1);
    for (const Job& job : jobs)
      m_nodes[job.parent].child[job.position] = append(job.nodes);
  }

  /// The root is the first.
  std::vector<Node> take_nodes() { return std::move(m_nodes); }

private:
  static constexpr std::size_t boxes_of_a_job = 4096;
  static constexpr int maximum_depth_of_cheap_splits = maximum_depth - 32;
  static constexpr std::size_t width = Node::width;
  static_assert(width == Box_partition::group_size, "parts of this size are not split");

  /// A subtree to be built.
  struct Job
  {
    Part part;
    int depth;
    std::size_t parent, position; // among its children
    std::vector<Node> nodes;      // numbered within it
  };

  /// Adds a subtree; returns its root.
  Child append(const std::vector<Node>& nodes)
  {
    const Child first = Child(2 * m_nodes.size());
    for (Node node : nodes) {
      for (Child& child : node.child)
        child += child % 2 == 0 ? first : 0;
      m_nodes.push_back(node);
    }
    return first;
  }

  /// Adds a node for a part, and its descendants; those of few boxes become jobs, if these are wanted.
  Child add_node(const Part& part, int depth, std::vector<Node>& nodes, std::vector<Job>* jobs) const
  {
    std::array<Part, width> parts{};
    const std::size_t size = split(part, depth, parts);
    const std::size_t n = nodes.size();
    nodes.emplace_back();
    for (std::size_t i = 0; i < width; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        nodes[n].bounds[0][k][i] = parts[i].box.low[k];
        nodes[n].bounds[1][k][i] = parts[i].box.high[k];
      }
    for (std::size_t i = 0; i < size; ++i)
      if (parts[i].size() == 1)
        nodes[n].child[i] = Child(2 * m_boxes.name(parts[i].first) + 1);
      else if (jobs && parts[i].size() <= boxes_of_a_job)
        jobs->push_back({parts[i], depth + 1, n, i, {}});
      else {
        const Child child = add_node(parts[i], depth + 1, nodes, jobs);
        nodes[n].child[i] = child;
      }
    return Child(2 * n);
  }

  /// Splits a part for the children of a node; returns their number.
  std::size_t split(const Part& part, int depth, std::array<Part, width>& parts) const
  {
    std::size_t size = 0;
    if (part.size() <= width) {
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
  std::vector<Node> m_nodes;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_RAYS_BOX_TREE_BUILDER_H
