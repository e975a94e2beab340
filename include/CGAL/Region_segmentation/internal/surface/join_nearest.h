// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_JOIN_NEAREST_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_JOIN_NEAREST_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/support/Lowest_root_forest.h>
#include <CGAL/Region_segmentation/internal/surface/Component_tree.h>
#include <CGAL/Region_segmentation/internal/surface/Added_adjacency.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Links the nearest components of different groups until there is one group: Kruskal's algorithm,
/// a minimum spanning tree by the distance of their nearest faces, ties by the lower, then the
/// higher of these. Of faces of two components at the same distance those are taken that are found
/// first; this depends on nothing but the surface.
///
/// The pairs of components by distance come from one queue, which also holds pairs of nodes by the
/// gap between their boxes. Pairs in one group are dropped. Near linear: only faces whose boxes are
/// nearer than the components are compared. Where the boxes of very many components overlap, pairs
/// are joined as they come after 16 C + 100,000 pairs of components, or eight times as many of
/// nodes, C the number of components.
class Nearest_joiner
{
public:
  using Index = Surface::Index;

  /// `links`: components with a link are in one group
  Nearest_joiner(Component_tree& tree, const Partition& component_of_face,
                 std::vector<Added_adjacency>& links)
    : m_tree(tree)
    , m_component_of(component_of_face)
    , m_links(links)
    , m_groups(component_of_face.number_of_parts())
    , m_number_of_groups(component_of_face.number_of_parts())
  {
    for (const Added_adjacency& l : links)
      unite(l.lower, l.higher);
  }

  void run(const Execution& execution)
  {
    Step_counter counter(execution, m_number_of_groups - 1);
    m_queue.push({0, false, m_tree.root(), m_tree.root()});
    while (m_number_of_groups > 1) {
      const Pair pair = m_queue.top();
      m_queue.pop();
      if (pair.is_of_faces) {
        join(pair, counter);
      } else if (m_effort > most_effort()) {
        join_all(pair.a, pair.b, counter);
      } else if (!in_one_group(pair.a, pair.b)) {
        divide(pair.a, pair.b);
      }
    }
  }

private:
  struct Pair
  {
    double squared_distance;
    bool is_of_faces; ///< or of nodes, which come first
    Index a, b;

    auto key() const { return std::make_tuple(squared_distance, is_of_faces, a, b); }
    friend bool operator<(const Pair& p, const Pair& q)
    {
      return p.key() > q.key();
    } // lowest first
  };

  bool unite(Index face, Index other)
  {
    const bool were_apart = m_groups.unite(m_component_of[face], m_component_of[other]);
    m_number_of_groups -= were_apart;
    return were_apart;
  }

  /// Links the components of two faces, if they are in different groups.
  void join(const Pair& faces, Step_counter& counter)
  {
    if (unite(faces.a, faces.b)) {
      m_links.push_back(link_of(faces.a, faces.b, 0));
      counter.advance();
    }
  }

  /// The root of the group of all components of a node, `none` if they are in several.
  Index group(Index node)
  {
    if (m_tree[node].component != Component_tree::none)
      return m_groups.root(m_tree[node].component);
    if (node < m_members.size() && m_members[node] != Component_tree::none)
      return m_groups.root(m_members[node]);
    const Index child = m_tree.children(node), result = group(child);
    if (result == Component_tree::none || result != group(child + 1))
      return Component_tree::none;
    if (node >= m_members.size())
      m_members.resize(node + 1, Index(Component_tree::none));
    return m_members[node] = result;
  }

  bool in_one_group(Index a, Index b)
  {
    const Index g = group(a);
    return g != Component_tree::none && (a == b || g == group(b));
  }

  void push(Index a, Index b)
  {
    m_queue.push({gap(a, b), false, (std::min)(a, b), (std::max)(a, b)});
  }

  void divide(Index a, Index b)
  {
    if (are_components(a, b)) {
      m_effort += effort_of_components;
      m_queue.push(nearest_faces(a, b));
      return;
    }
    ++m_effort;
    const Index node = a == b ? a : node_of_components(a, b);
    const Index child = m_tree.children(node);
    if (a == b) {
      m_queue.push({0, false, child, child});
      m_queue.push({0, false, child + 1, child + 1});
      push(child, child + 1);
    } else {
      push(child, node == a ? b : a);
      push(child + 1, node == a ? b : a);
    }
  }

  /// Joins the components of two nodes as they come, depth first.
  void join_all(Index a, Index b, Step_counter& counter)
  {
    if (in_one_group(a, b))
      return;
    if (are_components(a, b)) {
      join(nearest_faces(a, b), counter);
      return;
    }
    const Index node = a == b ? a : node_of_components(a, b);
    const Index child = m_tree.children(node), other = node == a ? b : a;
    join_all(child, a == b ? child : other, counter);
    join_all(child + 1, a == b ? child + 1 : other, counter);
    if (a == b)
      join_all(child, child + 1, counter);
  }

  bool are_components(Index a, Index b) const
  {
    return a != b && m_tree[a].component != Component_tree::none &&
           m_tree[b].component != Component_tree::none;
  }

  /// The one of two nodes to divide that has several components.
  Index node_of_components(Index a, Index b) const
  {
    if (m_tree[a].component != Component_tree::none)
      return b;
    return m_tree[b].component != Component_tree::none ? a : m_tree.node_to_divide(a, b);
  }

  double gap(Index a, Index b) const { return squared_gap(m_tree[a].box, m_tree[b].box); }

  Pair nearest_faces(Index a, Index b)
  {
    Pair nearest{std::numeric_limits<double>::infinity(), true, 0, 0};
    find_nearest_faces(a, b, nearest);
    return nearest;
  }

  /// Depth first, the nearer child first.
  void find_nearest_faces(Index a, Index b, Pair& nearest)
  {
    const Index node = m_tree.node_to_divide(a, b), other = node == a ? b : a;
    if (node == Component_tree::none) {
      m_tree.for_each_near(
        a, b, nearest.squared_distance,
        [&](const Component_tree::Part& p, const Component_tree::Part& q, double) {
          const Pair pair{squared_distance(m_tree.triangle(p), m_tree.triangle(q)), true,
                          (std::min)(p.face, q.face), (std::max)(p.face, q.face)};
          if (nearest < pair)
            nearest = pair;
        });
      return;
    }
    Index nearer = m_tree.children(node), farther = nearer + 1;
    if (gap(farther, other) < gap(nearer, other))
      std::swap(nearer, farther);
    for (Index child : {nearer, farther})
      if (gap(child, other) < nearest.squared_distance)
        find_nearest_faces(child, other, nearest);
  }

  static constexpr std::size_t effort_of_components = 8; // of a pair; 1 for nodes

  std::size_t most_effort() const
  {
    return effort_of_components * (16 * m_component_of.number_of_parts() + 100000);
  }

  Component_tree& m_tree;
  const Partition& m_component_of;
  std::vector<Added_adjacency>& m_links;
  Lowest_root_forest m_groups; // of components
  std::size_t m_number_of_groups, m_effort = 0;
  std::vector<Index> m_members; // by node: a component, if all are known to be in one group
  std::priority_queue<Pair> m_queue;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_JOIN_NEAREST_H
