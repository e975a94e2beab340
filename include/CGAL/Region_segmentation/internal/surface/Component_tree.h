// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_COMPONENT_TREE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_COMPONENT_TREE_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/Function_ref.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>
#include <CGAL/Region_segmentation/internal/surface/Axis_box.h>
#include <CGAL/Region_segmentation/internal/surface/distances.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A hierarchy of boxes over the components of a surface and, below each of them, over its faces,
/// divided into triangles from their first corner. A node is divided when its children are first
/// asked for: far from other components faces are never sorted.
///
/// Bytes: 20 per triangle, and 72 per node.
class Component_tree
{
public:
  using Index = Surface::Index;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  struct Part
  {
    std::array<Index, 3> corners;
    Index face;
  };

  /// Parts of a component, or several components.
  struct Node
  {
    Axis_box box;
    Index begin, end;      ///< of the items
    Index children = none; ///< the first one, the second follows
    Index component;       ///< `none` if there are several
    double tolerance;      ///< the largest one of its components
  };

  /// `tolerances`: by component; empty: all are 0
  Component_tree(const Surface& surface, const Partition& component_of_face,
                 std::vector<double> tolerances = {})
    : m_surface(surface)
    , m_tolerances(std::move(tolerances))
    , m_boxes(component_of_face.number_of_parts())
  {
    m_tolerances.resize(m_boxes.size());
    group_faces(component_of_face);
    m_items.resize(m_boxes.size() + m_parts.all().size());
    std::iota(m_items.begin(), m_items.begin() + std::ptrdiff_t(m_boxes.size()), Index(0));
    std::iota(m_items.begin() + std::ptrdiff_t(m_boxes.size()), m_items.end(), Index(0));
    add_node_of_components(0, Index(m_boxes.size()));
  }

  /// A bound of the pairs of faces that are compared, for thousands of triangles that all cross, or
  /// are near, each other.
  static constexpr std::size_t most_pairs(std::size_t number_of_faces)
  {
    return 64 * number_of_faces + 1000000;
  }

  static constexpr Index root() { return 0; }
  /// Valid until a node is divided.
  const Node& operator[](Index node) const { return m_nodes[node]; }
  bool is_leaf(Index node) const
  {
    const Node& n = m_nodes[node];
    return n.component != none && n.end - n.begin <= leaf_size;
  }

  /// \pre the item is one of a leaf
  const Part& part(Index item) const { return m_parts.all()[m_items[item]]; }

  Triangle triangle(const Part& p) const
  {
    return {m_surface.point(p.corners[0]), m_surface.point(p.corners[1]),
            m_surface.point(p.corners[2])};
  }

  /// The first of the two children.
  /// \pre the node is no leaf
  Index children(Index node)
  {
    if (m_nodes[node].children == none)
      divide(node);
    return m_nodes[node].children;
  }

  /// Which of two nodes to divide to tell them apart; `none` if both are leaves.
  Index node_to_divide(Index a, Index b) const
  {
    if (is_leaf(a) || is_leaf(b))
      return !is_leaf(a) ? a : !is_leaf(b) ? b : none;
    const Axis_box &s = m_nodes[a].box, &t = m_nodes[b].box;
    const double x = s.extent(s.longest_axis()), y = t.extent(t.longest_axis());
    return x > y ||
               (x == y && m_nodes[a].end - m_nodes[a].begin >= m_nodes[b].end - m_nodes[b].begin)
             ? a
             : b;
  }

  /// Calls `f(part, other, squared_gap)` for the parts of two leaves whose boxes are not farther
  /// from each other than `squared_bound`, which `f` may lower.
  void for_each_near(Index a, Index b, const double& squared_bound,
                     Function_ref<void(const Part&, const Part&, double)> f) const
  {
    for (Index i = m_nodes[a].begin; i < m_nodes[a].end; ++i) {
      const Axis_box box_of_part = box(part(i));
      if (squared_gap(box_of_part, m_nodes[b].box) > squared_bound)
        continue;
      for (Index j = m_nodes[b].begin; j < m_nodes[b].end; ++j)
        if (const double gap = squared_gap(box_of_part, box(part(j))); gap <= squared_bound)
          f(part(i), part(j), gap);
    }
  }

private:
  static constexpr Index leaf_size = 4;

  Axis_box box(const Part& p) const { return box_of(triangle(p)); }

  void group_faces(const Partition& component_of_face)
  {
    m_parts = Grouped_items<Part>(m_boxes.size(), [&](const auto& add) {
      for (Index f = 0; f < component_of_face.size(); ++f) {
        const std::size_t n = m_surface.number_of_corners(f);
        const auto corner = [&](std::size_t c) {
          return m_surface.corner(f, (std::min)(c, n - 1));
        };
        for (std::size_t i = 0; i == 0 || i + 2 < n; ++i)
          add(component_of_face[f], {{corner(0), corner(i + 1), corner(i + 2)}, f});
      }
    });
    for (std::size_t c = 0; c < m_boxes.size(); ++c)
      for (const Part& part : m_parts[c])
        m_boxes[c].add(box(part));
  }

  void divide(Index node)
  {
    const Node n = m_nodes[node];
    const Index children = Index(m_nodes.size()), at = split(n);
    for (const auto& [begin, end] : {std::make_pair(n.begin, at), std::make_pair(at, n.end)})
      if (n.component == none)
        add_node_of_components(begin, end);
      else
        add_node_of_faces(n, begin, end);
    m_nodes[node].children = children;
  }

  /// In the middle of the box, or at the median where this leaves one child with less than an
  /// eighth: then the depth is logarithmic.
  Index split(const Node& n)
  {
    const std::size_t axis = n.box.longest_axis();
    const double middle = n.box.center(axis);
    const auto begin = m_items.begin() + n.begin, end = m_items.begin() + n.end;
    const auto at = std::partition(begin, end,
                                   [&](Index i) { return position(n, i, axis) < middle; });
    if ((std::min)(at - begin, end - at) * 8 >= end - begin)
      return Index(at - m_items.begin());
    const auto median = begin + (end - begin) / 2;
    const auto less = [&](Index i, Index j) { return position(n, i, axis) < position(n, j, axis); };
    std::nth_element(begin, median, end, Function_ref<bool(Index, Index)>(less));
    return Index(median - m_items.begin());
  }

  /// The center of a part in a node, or where a component begins: so components with one center are
  /// in the order of their sizes.
  double position(const Node& n, Index i, std::size_t axis) const
  {
    if (n.component == none)
      return m_boxes[i].low[axis];
    double sum = 0;
    for (const Double_3& p : triangle(m_parts.all()[i]))
      sum += std::array{p.x, p.y, p.z}[axis];
    return sum / 3;
  }

  void add_node_of_components(Index begin, Index end)
  {
    Node n;
    n.begin = begin;
    n.end = end;
    n.component = none;
    n.tolerance = 0;
    for (Index i = begin; i < end; ++i) {
      n.box.add(m_boxes[m_items[i]]);
      n.tolerance = (std::max)(n.tolerance, m_tolerances[m_items[i]]);
    }
    if (end - begin == 1) {
      n.component = m_items[begin];
      const auto parts = m_parts[n.component];
      n.begin = Index(m_boxes.size()) + Index(parts.begin() - m_parts.all().data());
      n.end = n.begin + Index(parts.size());
    }
    m_nodes.push_back(n);
  }

  void add_node_of_faces(const Node& parent, Index begin, Index end)
  {
    Node n = parent;
    n.box = Axis_box();
    n.begin = begin;
    n.end = end;
    n.children = none;
    for (Index i = begin; i < end; ++i)
      n.box.add(box(part(i)));
    m_nodes.push_back(n);
  }

  const Surface& m_surface;
  std::vector<double> m_tolerances;
  std::vector<Axis_box> m_boxes; // by component
  Grouped_items<Part> m_parts;   // by component
  std::vector<Index> m_items;    // the components, then the parts, in the order of the nodes
  std::vector<Node> m_nodes;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_COMPONENT_TREE_H
