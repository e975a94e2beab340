// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_JOIN_NEAREST_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_JOIN_NEAREST_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/Lowest_root_forest.h>
#include <CGAL/Region_segmentation/internal/surface/Added_adjacency.h>
#include <CGAL/Region_segmentation/internal/surface/Component_tree.h>
#include <CGAL/Region_segmentation/internal/surface/distances.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Links the nearest components of different groups until there is one group: the minimum spanning
/// tree by the squared distances of faces, rounded to 24 bits: the nearest point of a component is
/// often one of several faces. Of these the smallest are taken, of equal ones by the places of
/// their corners; so neither rounding nor the numbers of faces decide.
///
/// By the algorithm of Boruvka: in each round every group finds the face of another one that is
/// nearest to it, and is joined to it. Pairs of nodes of the tree are left out where both are in
/// one group, or farther from each other than what all groups in them have found. At most log C
/// rounds, C the number of components, each near linear. Where very many faces are about as near as
/// the nearest ones, so that more pairs than `Component_tree::most_pairs()` are compared, a group
/// is joined to what it has found.
///
/// Source: W. B. March, P. Ram, A. G. Gray: Fast Euclidean minimum spanning tree: algorithm,
/// analysis, and applications. KDD 2010.
class Nearest_joiner
{
public:
  using Index = Surface::Index;

  /// `links`: components with a link are in one group
  Nearest_joiner(const Surface& surface, Component_tree& tree, const Partition& component_of_face,
                 std::vector<Added_adjacency>& links)
    : m_surface(surface)
    , m_tree(tree)
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
    Step_counter counter(execution, m_number_left);
    while (m_number_of_groups > 1) {
      m_nearest.assign(m_component_of.number_of_parts(), Pair());
      m_states.clear();
      visit(m_tree.root(), m_tree.root(), counter);
      for (const Pair& pair : m_nearest)
        if (pair.part != nullptr && unite(pair.part->face, pair.other->face))
          m_links.push_back(link_of(pair.part->face, pair.other->face, 0));
    }
  }

private:
  static constexpr Index none = Component_tree::none;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Of triangles of faces; none by default.
  struct Pair
  {
    double squared_distance = infinity;
    const Component_tree::Part *part = nullptr, *other = nullptr;

    /// Of the squared distance of what may be nearer.
    double bound() const { return (1 + 1e-6) * squared_distance; }
  };

  /// Of a node in a round.
  struct State
  {
    bool is_known = false;
    Index group = none;      ///< of all of its components; `none` if they are in several
    double bound = infinity; ///< of what these groups have found, if they are several
  };

  static double rounded(double x)
  {
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    return std::ldexp(std::round(std::ldexp(mantissa, 24)), exponent - 24);
  }

  /// The area, the corners in order, and the face.
  auto size_and_place(const Component_tree::Part& part) const
  {
    std::array<std::array<double, 3>, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const Double_3& p = m_surface.point(part.corners[i]);
      corners[i] = {p.x, p.y, p.z};
    }
    std::sort(corners.begin(), corners.end());
    return std::make_tuple(rounded(m_surface.area(part.face)), corners, part.face);
  }

  bool is_nearer(const Pair& p, const Pair& q) const
  {
    if (p.squared_distance != q.squared_distance || q.part == nullptr)
      return p.squared_distance < q.squared_distance;
    const auto key = [&](const Pair& pair) {
      std::array faces = {size_and_place(*pair.part), size_and_place(*pair.other)};
      std::sort(faces.begin(), faces.end());
      return faces;
    };
    return key(p) < key(q);
  }

  bool unite(Index face, Index other)
  {
    const bool were_apart = m_groups.unite(m_component_of[face], m_component_of[other]);
    m_number_of_groups -= were_apart;
    return were_apart;
  }

  /// Of all components of a node; `none` if they are in several.
  Index group(Index node)
  {
    if (m_tree[node].component != none)
      return m_groups.root(m_tree[node].component);
    if (node < m_states.size() && m_states[node].is_known)
      return m_states[node].group;
    const Index child = m_tree.children(node), first = group(child), second = group(child + 1);
    if (node >= m_states.size())
      m_states.resize(node + 1);
    m_states[node] = {true, first == second ? first : none, infinity};
    return m_states[node].group;
  }

  bool in_one_group(Index a, Index b)
  {
    const Index g = group(a);
    return g != none && (a == b || g == group(b));
  }

  /// The largest squared distance of what the groups of a node have found.
  double bound(Index node)
  {
    const Index g = group(node);
    return g != none ? m_nearest[g].bound() : m_states[node].bound;
  }
  double bound(Index a, Index b) { return (std::max)(bound(a), bound(b)); }

  double gap(Index a, Index b) const { return squared_gap(m_tree[a].box, m_tree[b].box); }

  /// Depth first, the nearer child first.
  void visit(Index a, Index b, Step_counter& counter)
  {
    if (in_one_group(a, b))
      return;
    if (a == b) {
      const Index child = m_tree.children(a);
      visit(child, child, counter);
      visit(child + 1, child + 1, counter);
      visit(child, child + 1, counter);
      update_bound(a, child);
      return;
    }
    const double largest = bound(a, b);
    if (gap(a, b) > largest || (m_number_left == 0 && largest < infinity))
      return;
    const Index node = m_tree.node_to_divide(a, b), other = node == a ? b : a;
    if (node == none) {
      compare_faces(a, b, counter);
      return;
    }
    const Index child = m_tree.children(node);
    const bool is_second_nearer = gap(child + 1, other) < gap(child, other);
    visit(child + is_second_nearer, other, counter);
    visit(child + !is_second_nearer, other, counter);
    update_bound(node, child);
  }

  void update_bound(Index node, Index child)
  {
    if (group(node) == none)
      m_states[node].bound = (std::min)(m_states[node].bound, bound(child, child + 1));
  }

  /// \pre both nodes are leaves
  void compare_faces(Index a, Index b, Step_counter& counter)
  {
    double largest = bound(a, b);
    const auto compare = [&](const Component_tree::Part& p, const Component_tree::Part& q, double) {
      const Triangle s = m_tree.triangle(p), t = m_tree.triangle(q);
      if (squared_separation(s, t) > largest)
        return;
      counter.advance();
      if (m_number_left > 0)
        --m_number_left;
      const Pair pair{rounded(squared_distance(s, t)), &p, &q};
      for (const Index node : {a, b})
        if (Pair& nearest = m_nearest[group(node)]; is_nearer(pair, nearest))
          nearest = pair;
      largest = bound(a, b);
    };
    m_tree.for_each_near(a, b, largest, compare);
  }

  const Surface& m_surface;
  Component_tree& m_tree;
  const Partition& m_component_of;
  std::vector<Added_adjacency>& m_links;
  Lowest_root_forest m_groups; // of components
  std::size_t m_number_of_groups;
  std::vector<Pair> m_nearest; // in a round, by the lowest component of a group
  std::vector<State> m_states; // in a round, by node of several components
  std::size_t m_number_left = Component_tree::most_pairs(m_component_of.size());
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_JOIN_NEAREST_H
