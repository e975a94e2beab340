// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEAM_FINDER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEAM_FINDER_H

#include <CGAL/Region_segmentation/internal/support/Lowest_root_forest.h>
#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>
#include <CGAL/Region_segmentation/internal/support/shortest_paths.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// An edge inside a segment.
struct Inner_edge
{
  std::uint32_t vertices[2], faces[2];
  double cost; // of a seam along it
};

/// Finds short paths that open every component of every segment to a disc, all at once, by tree and cotree:
/// the shortest path tree of a component grows from all of its border, or from a vertex if it is closed; a spanning tree
/// of its dual crosses edges that are not in the tree, and those first whose detour to the border is longest. Every edge
/// in neither tree becomes a seam with its paths to the border: 2 g + b - 1 arcs for genus g and b > 0 loops, or 2 g loops
/// through the root.
///
/// A sphere is opened along a shortest path between two vertices far from each other.
///
/// Source: Erickson and Whittlesey 2005; with borders, Erickson and Har-Peled 2004.
class Seam_finder
{
public:
  using Index = std::uint32_t;

  /// `is_border`: of the vertices. Those inside a segment are on no edges of others.
  Seam_finder(std::vector<Inner_edge> edges, const std::vector<char>& is_border, std::size_t number_of_faces)
    : m_edges(std::move(edges)), m_is_border(is_border), m_number_of_faces(number_of_faces)
    , m_edges_at(is_border.size()), m_distances(is_border.size(), infinity), m_tree_edge(is_border.size(), Index(none))
    , m_is_seam(m_edges.size(), false)
  {
    for (const Inner_edge& e : m_edges)
      for (Index v : e.vertices)
        m_edges_at.count(v);
    m_edges_at.end_counting();
    for (std::size_t e = 0; e < m_edges.size(); ++e)
      for (Index v : m_edges[e].vertices)
        m_edges_at.add(v, Index(e));
  }

  /// Whether each edge is a seam.
  std::vector<char> find()
  {
    grow_trees_from_borders();
    const std::vector<Closed_component> closed = grow_trees_of_closed_components();
    add_arcs();
    prune();
    for (const Closed_component& component : closed)
      if (!has_seam(component))
        open_sphere(component);
    return std::move(m_is_seam);
  }

private:
  static constexpr Index none = (std::numeric_limits<Index>::max)();
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  struct Closed_component
  {
    Index root, farthest;
    std::vector<Index> vertices;
  };

  Index other_end(Index edge, Index vertex) const
  {
    const Inner_edge& e = m_edges[edge];
    return e.vertices[0] == vertex ? e.vertices[1] : e.vertices[0];
  }

  /// Returns the vertices in the order of their distances.
  std::vector<Index> grow_tree(const std::vector<Index>& sources)
  {
    std::vector<Index> order;
    find_shortest_paths(
      sources, m_distances,
      [&](Index v) {
        order.push_back(v);
        return true;
      },
      [&](Index v, const auto& enter) {
        for (Index e : m_edges_at[v])
          if (const Index w = other_end(e, v); !m_is_border[w] && enter(w, m_edges[e].cost))
            m_tree_edge[w] = e;
      });
    return order;
  }

  void grow_trees_from_borders()
  {
    std::vector<Index> sources;
    for (std::size_t v = 0; v < m_is_border.size(); ++v)
      if (m_is_border[v])
        sources.push_back(Index(v));
    grow_tree(sources);
  }

  /// The root is the farthest vertex from the first one of the component.
  std::vector<Closed_component> grow_trees_of_closed_components()
  {
    std::vector<Closed_component> closed;
    for (std::size_t v = 0; v < m_distances.size(); ++v)
      if (m_distances[v] == infinity && !m_edges_at[v].empty()) {
        std::vector<Index> vertices = grow_tree({Index(v)});
        const Index root = vertices.back();
        for (Index w : vertices) {
          m_distances[w] = infinity;
          m_tree_edge[w] = none;
        }
        vertices = grow_tree({root});
        const Index farthest = vertices.back();
        closed.push_back({root, farthest, std::move(vertices)});
      }
    return closed;
  }

  bool is_in_tree(Index e) const
  {
    return m_tree_edge[m_edges[e].vertices[0]] == e || m_tree_edge[m_edges[e].vertices[1]] == e;
  }

  double length_of_arc(Index e) const
  {
    return m_distances[m_edges[e].vertices[0]] + m_edges[e].cost + m_distances[m_edges[e].vertices[1]];
  }

  void add_arcs()
  {
    std::vector<Index> candidates;
    std::vector<double> lengths(m_edges.size());
    for (std::size_t e = 0; e < m_edges.size(); ++e)
      if (!is_in_tree(Index(e))) {
        candidates.push_back(Index(e));
        lengths[e] = length_of_arc(Index(e));
      }
    std::stable_sort(candidates.begin(), candidates.end(), [&](Index a, Index b) { return lengths[a] > lengths[b]; });
    Lowest_root_forest faces(m_number_of_faces);
    for (Index e : candidates)
      if (!faces.unite(m_edges[e].faces[0], m_edges[e].faces[1]))
        for (Index v : m_edges[e].vertices) {
          m_is_seam[e] = true;
          add_path(v);
        }
  }

  /// From a vertex to the border, or to the root.
  void add_path(Index v)
  {
    while (m_tree_edge[v] != none && !m_is_seam[m_tree_edge[v]]) {
      const Index e = m_tree_edge[v];
      m_is_seam[e] = true;
      v = other_end(e, v);
    }
  }

  std::size_t number_of_seams_at(Index v) const
  {
    return std::size_t(std::count_if(m_edges_at[v].begin(), m_edges_at[v].end(), [&](Index e) { return m_is_seam[e]; }));
  }

  /// Removes paths that end inside: in closed components, that to the root.
  void prune()
  {
    for (std::size_t start = 0; start < m_is_border.size(); ++start)
      for (Index v = Index(start); !m_is_border[v] && number_of_seams_at(v) == 1;) {
        const Index e = *std::find_if(m_edges_at[v].begin(), m_edges_at[v].end(), [&](Index i) { return m_is_seam[i]; });
        m_is_seam[e] = false;
        v = other_end(e, v);
      }
  }

  bool has_seam(const Closed_component& component) const
  {
    return std::any_of(component.vertices.begin(), component.vertices.end(),
                       [&](Index v) { return number_of_seams_at(v) > 0; });
  }

  /// Along at least two edges, where there are: one alone would give a border of two vertices.
  void open_sphere(const Closed_component& component)
  {
    add_path(component.farthest);
    if (other_end(m_tree_edge[component.farthest], component.farthest) != component.root)
      return;
    for (Index e : m_edges_at[component.farthest])
      if (other_end(e, component.farthest) != component.root) {
        m_is_seam[e] = true;
        return;
      }
  }

  const std::vector<Inner_edge> m_edges;
  const std::vector<char>& m_is_border;
  const std::size_t m_number_of_faces;
  Grouped_items<Index> m_edges_at; // by vertex
  std::vector<double> m_distances; // from the border, or from the root; by vertex
  std::vector<Index> m_tree_edge;  // towards it
  std::vector<char> m_is_seam;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEAM_FINDER_H
