// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_MEASURES_EDGE_GRAPH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_MEASURES_EDGE_GRAPH_H

#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>
#include <CGAL/Region_segmentation/internal/support/shortest_paths.h>
#include <CGAL/Region_segmentation/internal/surface/Mesh_order.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The vertices and edges of a mesh as arrays, for shortest paths along edges. Made from the range
/// of edges, so a vertex where several fans of faces meet has the edges of all. 32 bytes an edge.
class Edge_graph
{
public:
  using Index = Surface::Index;

  template <typename FaceGraph, typename Pack>
  Edge_graph(const Mesh_order<FaceGraph, Pack>& order, const Surface& surface)
    : m_incident_edges(order.number_of_vertices(), [&](const auto& add) {
      for (auto e : edges(order.mesh())) {
        const auto h = halfedge(e, order.mesh());
        const std::size_t v = order.vertex_rank(source(h, order.mesh())),
                          w = order.vertex_rank(target(h, order.mesh()));
        const double length = norm(surface.point(v) - surface.point(w));
        add(v, {Index(w), length});
        add(w, {Index(v), length});
      }
    })
  {}

  /// The sum over `targets`, which are different, of the length of the shortest path along edges to
  /// the nearest of `sources`; infinite where a target has no path. One run of Dijkstra's algorithm
  /// from all sources, up to the last target. O(E log E).
  double sum_of_distances(const std::vector<Index>& sources,
                          const std::vector<Index>& targets) const
  {
    std::vector<double> distance(number_of_vertices(), std::numeric_limits<double>::infinity());
    std::vector<char> is_target(number_of_vertices(), false);
    for (Index t : targets)
      is_target[t] = true;
    std::size_t targets_left = targets.size();
    if (targets_left > 0)
      find_shortest_paths(
        sources, distance,
        [&](Index v) {
          targets_left -= std::size_t(is_target[v]);
          return targets_left > 0;
        },
        [&](Index v, const auto& enter) {
          for (const Incident_edge& edge : m_incident_edges[v])
            enter(edge.to, edge.length);
        });

    double sum = 0;
    for (Index t : targets)
      sum += distance[t];
    return sum;
  }

private:
  std::size_t number_of_vertices() const { return m_incident_edges.number_of_groups(); }

  struct Incident_edge
  {
    Index to;
    double length;
  };

  Grouped_items<Incident_edge> m_incident_edges; // by vertex
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_MEASURES_EDGE_GRAPH_H
