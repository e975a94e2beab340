// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_FLOW_NETWORK_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_FLOW_NETWORK_H

#include <CGAL/Region_segmentation/internal/support/Grouped_items.h>

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Undirected edges with capacities as the compact directed graph, with arcs both ways, that
/// `boost::boykov_kolmogorov_max_flow()` works on.
template <typename Capacity>
class Flow_network
{
  using Index = std::uint32_t;
  using Graph = boost::compressed_sparse_row_graph<
    boost::directedS, boost::no_property, boost::no_property, boost::no_property, Index, Index>;
  using Arc = typename boost::graph_traits<Graph>::edge_descriptor;

public:
  Flow_network(std::size_t number_of_nodes, std::size_t number_of_edges)
    : m_arcs_of_node(number_of_nodes)
  {
    m_edges.reserve(number_of_edges);
  }

  void add_edge(Index a, Index b, Capacity capacity)
  {
    m_edges.push_back({a, b, capacity});
    m_arcs_of_node.count(a);
    m_arcs_of_node.count(b);
  }

  /// Finds the maximum flow, once. Colors: black if a node is on the side of the source in every
  /// minimum cut, white if on that of the sink, gray otherwise. \pre a terminal has at most one
  /// edge to a node, and none to the other terminal
  void run(Index source, Index sink, std::vector<boost::default_color_type>& colors)
  {
    sort_arcs();
    const std::size_t n = m_arcs_of_node.number_of_groups();
    Graph graph(boost::edges_are_sorted, m_arcs.begin(), m_arcs.end(), Index(n));
    std::vector<Arc> reverse(m_arcs.size()), predecessors(n);
    for (auto range = edges(graph); range.first != range.second; ++range.first)
      reverse[m_reverse[get(boost::edge_index, graph, *range.first)]] = *range.first;
    std::vector<Capacity> residual(m_arcs.size());
    std::vector<std::size_t> distances(n);

    const auto arc_index = get(boost::edge_index, graph);
    const auto node_index = get(boost::vertex_index, graph);
    boost::boykov_kolmogorov_max_flow(
      graph, boost::make_iterator_property_map(m_capacities.begin(), arc_index),
      boost::make_iterator_property_map(residual.begin(), arc_index),
      boost::make_iterator_property_map(reverse.begin(), arc_index),
      boost::make_iterator_property_map(predecessors.begin(), node_index),
      boost::make_iterator_property_map(colors.begin(), node_index),
      boost::make_iterator_property_map(distances.begin(), node_index), node_index, source, sink);
  }

private:
  struct Edge
  {
    Index a, b;
    Capacity capacity;
  };

  /// By where the arcs start.
  void sort_arcs()
  {
    m_arcs_of_node.end_counting();
    for (Index e = 0; e < m_edges.size(); ++e) {
      m_arcs_of_node.add(m_edges[e].a, 2 * e);
      m_arcs_of_node.add(m_edges[e].b, 2 * e + 1);
    }
    std::vector<Index> place(2 * m_edges.size()); // by arc
    for (std::size_t node = 0; node < m_arcs_of_node.number_of_groups(); ++node)
      for (Index arc : m_arcs_of_node[node]) {
        const Edge& edge = m_edges[arc / 2];
        place[arc] = Index(m_arcs.size());
        m_arcs.push_back(arc % 2 == 0 ? std::make_pair(edge.a, edge.b)
                                      : std::make_pair(edge.b, edge.a));
        m_capacities.push_back(edge.capacity);
      }
    m_reverse.resize(m_arcs.size());
    for (std::size_t arc = 0; arc < place.size(); ++arc)
      m_reverse[place[arc]] = place[arc ^ 1];
  }

  std::vector<Edge> m_edges;
  Grouped_items<Index> m_arcs_of_node;         // 2e and 2e + 1 are those of an edge, there and back
  std::vector<std::pair<Index, Index>> m_arcs; // source, target
  std::vector<Capacity> m_capacities;
  std::vector<Index> m_reverse;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_FLOW_NETWORK_H
