// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_EDGE_GRAPH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_EDGE_GRAPH_H

#include <CGAL/Region_segmentation/internal/Mesh_walk.h>
#include <CGAL/Region_segmentation/internal/Vector_3.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The vertices and edges of a mesh as arrays, for shortest paths along edges. Made from the range
/// of edges, so a vertex where several fans of faces meet has the edges of all. 32 bytes an edge.
class Edge_graph
{
public:
  using Index = Flat_mesh::Index;

  template <typename FaceGraph, typename Pack>
  Edge_graph(const Mesh_walk<FaceGraph, Pack>& walk, const std::vector<Vector_3>& points)
      : m_starts(walk.number_of_vertices() + 2)
  {
    // m_starts[v + 2] counts the edges of v, then holds their end; filling moves m_starts[v + 1]
    // from the start of v to its end, which is the start of the next one.
    for_each_edge(walk, [&](std::size_t v, std::size_t w) {
      ++m_starts[v + 2];
      ++m_starts[w + 2];
    });
    for (std::size_t i = 2; i < m_starts.size(); ++i)
      m_starts[i] += m_starts[i - 1];
    m_ways.resize(m_starts.back());
    for_each_edge(walk, [&](std::size_t v, std::size_t w) {
      const double length = norm(points[v] - points[w]);
      m_ways[m_starts[v + 1]++] = {Index(w), length};
      m_ways[m_starts[w + 1]++] = {Index(v), length};
    });
  }

  /// The sum over `targets`, which are different, of the length of the shortest path along edges to
  /// the nearest of `sources`; infinite where a target has no path. One run of Dijkstra's algorithm
  /// from all sources, up to the last target. O(E log E).
  double sum_of_distances(const std::vector<Index>& sources,
                          const std::vector<Index>& targets) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    std::vector<double> distance(number_of_vertices(), infinity);
    std::vector<char> is_target(number_of_vertices(), false);
    std::size_t targets_left = targets.size();

    for (Index t : targets)
      is_target[t] = true;
    for (Index s : sources) {
      distance[s] = 0;
      queue.push({0, s});
    }
    while (!queue.empty() && targets_left > 0) {
      const auto [d, v] = queue.top();
      queue.pop();
      if (d > distance[v]) // an entry from before a shorter path was found
        continue;
      targets_left -= is_target[v];
      for (std::size_t i = m_starts[v]; i < m_starts[v + 1]; ++i) {
        const double through_v = d + m_ways[i].length;
        if (through_v < distance[m_ways[i].to])
          queue.push({distance[m_ways[i].to] = through_v, m_ways[i].to});
      }
    }

    double sum = 0;
    for (Index t : targets)
      sum += distance[t];
    return sum;
  }

private:
  std::size_t number_of_vertices() const { return m_starts.size() - 2; }

  template <typename FaceGraph, typename Pack, typename F>
  static void for_each_edge(const Mesh_walk<FaceGraph, Pack>& walk, F f)
  {
    for (auto e : edges(walk.mesh())) {
      const auto h = halfedge(e, walk.mesh());
      f(walk.source_rank(h), walk.source_rank(opposite(h, walk.mesh())));
    }
  }

  struct Way
  {
    Index to;
    double length;
  };

  std::vector<std::size_t> m_starts;
  std::vector<Way> m_ways;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_EDGE_GRAPH_H
