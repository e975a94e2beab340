// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FLOW_NETWORK_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FLOW_NETWORK_H

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
  using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property,
                                                   boost::no_property, boost::no_property, Index, Index>;
  using Arc = typename boost::graph_traits<Graph>::edge_descriptor;

public:
  Flow_network(std::size_t number_of_nodes, std::size_t number_of_edges)
    : m_first_arcs(number_of_nodes + 2)
  {
    m_edges.reserve(number_of_edges);
  }

  void add_edge(Index a, Index b, Capacity capacity)
  {
    m_edges.push_back({a, b, capacity});
    ++m_first_arcs[a + 2];
    ++m_first_arcs[b + 2];
  }

  /// Finds the maximum flow, once. Colors: black what is on the side of the source, white on that of the
  /// sink in every minimum cut, gray the rest.
  /// \pre a terminal has at most one edge to a node, and none to the other terminal
  void run(Index source, Index sink, std::vector<boost::default_color_type>& colors)
  {
    sort_arcs();
    const std::size_t n = m_first_arcs.size() - 2;
    Graph graph(boost::edges_are_sorted, m_arcs.begin(), m_arcs.end(), n);
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

  /// Counting sort by where the arcs start: they were counted two places further on, so that placing
  /// them moves each start to where it belongs.
  void sort_arcs()
  {
    for (std::size_t n = 2; n < m_first_arcs.size(); ++n)
      m_first_arcs[n] += m_first_arcs[n - 1];
    m_arcs.resize(2 * m_edges.size());
    m_capacities.resize(m_arcs.size());
    m_reverse.resize(m_arcs.size());
    for (const Edge& e : m_edges) {
      const Index there = m_first_arcs[e.a + 1]++, back = m_first_arcs[e.b + 1]++;
      m_arcs[there] = {e.a, e.b};
      m_arcs[back] = {e.b, e.a};
      m_capacities[there] = m_capacities[back] = e.capacity;
      m_reverse[there] = back;
      m_reverse[back] = there;
    }
  }

  std::vector<Edge> m_edges;
  std::vector<Index> m_first_arcs;
  std::vector<std::pair<Index, Index>> m_arcs; // source, target
  std::vector<Capacity> m_capacities;
  std::vector<Index> m_reverse;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FLOW_NETWORK_H
