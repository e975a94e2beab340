// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPERFACETS_BORDER_CUT_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPERFACETS_BORDER_CUT_H

#include <CGAL/Region_segmentation/internal/superfacets/Dual_graph.h>
#include <CGAL/Region_segmentation/internal/support/arrays.h>
#include <CGAL/Region_segmentation/internal/support/components.h>

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A graph whose nodes lie on two sides, source and sink, and the minimum cut between its two
/// terminals; of several, one that moves the fewest nodes. Boost.Graph finds the flow, in
/// compressed rows: in a `boost::adjacency_list`, the default method takes 8 % more instructions,
/// and a late constraint 30 %.
///
/// Capacities are rounded to integers, their sum being about 2^51 over the number of nodes. Sums
/// are exact, so the cut does not depend on the order of nodes and edges. None is 0: if every node
/// has a path to both terminals, it is connected to that of its new side by nodes of that side.
class Minimum_cut
{
public:
  using Node = std::uint32_t;
  static constexpr Node source = 0, sink = 1;

  Minimum_cut()
    : m_is_on_source_side{1, 0}
  {}

  Node add_node(std::uint8_t is_on_source_side)
  {
    m_is_on_source_side.push_back(is_on_source_side);
    return Node(m_is_on_source_side.size() - 1);
  }

  /// Edges without effect are omitted: loops, and edges between the terminals.
  void add_edge(Node a, Node b, double capacity)
  {
    if (a != b && (std::max)(a, b) > sink)
      m_edges.push_back({(std::min)(a, b), (std::max)(a, b), capacity});
  }

  /// Moves nodes to the other side where that lowers the capacity of the cut; returns whether any
  /// moved.
  bool improve()
  {
    std::vector<boost::default_color_type> colors(m_is_on_source_side.size());
    find_flow(colors);
    bool has_moved = false;
    for (std::size_t n = 0; n < colors.size(); ++n) {
      const std::uint8_t is_on_source_side = colors[n] == boost::black_color;
      has_moved |= is_on_source_side != m_is_on_source_side[n];
      m_is_on_source_side[n] = is_on_source_side;
    }
    return has_moved;
  }

  bool is_on_source_side(Node n) const { return m_is_on_source_side[n] != 0; }

private:
  using Capacity = std::int64_t;
  using Graph = boost::compressed_sparse_row_graph<
    boost::directedS, boost::no_property, boost::no_property, boost::no_property, Node, Node>;

  template <typename Number>
  struct Edge
  {
    Node lower, higher;
    Number capacity;
  };

  /// With capacities that are integers. Moving a node costs 1, and moving all less than the unit of
  /// the given capacities. Boost's algorithm does not support parallel edges between a node and a
  /// terminal: they are united.
  std::vector<Edge<Capacity>> edges_of_network() const
  {
    const std::size_t nodes = m_is_on_source_side.size();
    double total = 0;
    for (const Edge<double>& e : m_edges)
      total += e.capacity;
    const int exponent = total > 0 ? 50 - std::ilogb(total) - std::ilogb(double(nodes)) : 0;
    std::vector<Edge<Capacity>> edges;
    std::vector<std::array<Capacity, 2>> to_terminals(nodes, {0, 0});
    for (const auto& [lower, higher, capacity] : m_edges) {
      const auto rounded = Capacity(std::llround(std::scalbn(capacity, exponent)));
      const Capacity integral = (std::max)(Capacity(1), rounded) * Capacity(nodes);
      if (lower <= sink)
        to_terminals[higher][lower] += integral;
      else
        edges.push_back({lower, higher, integral});
    }
    for (Node n = sink + 1; n < nodes; ++n) {
      to_terminals[n][m_is_on_source_side[n] ? source : sink] += 1;
      for (const Node terminal : {source, sink})
        if (to_terminals[n][terminal] > 0)
          edges.push_back({terminal, n, to_terminals[n][terminal]});
    }
    return edges;
  }

  /// Finds the maximum flow. Colors: black if a node is on the side of the source in every minimum
  /// cut, white if on that of the sink, gray otherwise.
  void find_flow(std::vector<boost::default_color_type>& colors) const
  {
    const std::vector<Edge<Capacity>> network = edges_of_network();
    // Arcs by where they start; 2e and 2e + 1 are those of an edge, there and back.
    const Grouped_items<Node> by_start(colors.size(), [&](const auto& add) {
      for (Node e = 0; e < network.size(); ++e) {
        add(network[e].lower, 2 * e);
        add(network[e].higher, 2 * e + 1);
      }
    });
    const std::size_t size = by_start.all().size();
    std::vector<std::pair<Node, Node>> arcs; // start, end
    std::vector<Capacity> capacities, residual(size);
    std::vector<Node> place(size);
    arcs.reserve(size);
    capacities.reserve(size);
    for (const Node arc : by_start.all()) {
      const auto& [lower, higher, capacity] = network[arc / 2];
      place[arc] = Node(arcs.size());
      arcs.push_back(arc % 2 == 0 ? std::make_pair(lower, higher) : std::make_pair(higher, lower));
      capacities.push_back(capacity);
    }
    const Graph graph(boost::edges_are_sorted, arcs.begin(), arcs.end(), Node(colors.size()));
    std::vector<boost::graph_traits<Graph>::edge_descriptor> reverse(size),
      predecessors(colors.size());
    const auto arc_index = get(boost::edge_index, graph);
    for (auto range = edges(graph); range.first != range.second; ++range.first)
      reverse[place[by_start.all()[get(arc_index, *range.first)] ^ 1]] = *range.first;
    std::vector<std::size_t> distances(colors.size());
    const auto node_index = get(boost::vertex_index, graph);
    boost::boykov_kolmogorov_max_flow(
      graph, boost::make_iterator_property_map(capacities.begin(), arc_index),
      boost::make_iterator_property_map(residual.begin(), arc_index),
      boost::make_iterator_property_map(reverse.begin(), arc_index),
      boost::make_iterator_property_map(predecessors.begin(), node_index),
      boost::make_iterator_property_map(colors.begin(), node_index),
      boost::make_iterator_property_map(distances.begin(), node_index), node_index, source, sink);
  }

  std::vector<std::uint8_t> m_is_on_source_side;
  std::vector<Edge<double>> m_edges;
};

/// Moves the border between two pieces of a mesh to a minimum cut in a band around it. Elements are
/// faces, or patches; a piece that was connected still is.
class Border_cut
{
public:
  using Index = Dual_graph::Index;

  /// `costs`: of the borders between adjacent elements; `distance(i, j)`: of two of these, is kept
  /// by reference; `piece_of`: by element, is changed by `move_border()`
  Border_cut(const Dual_graph& costs, std::function<double(Index, Index)> distance,
             std::vector<Index>& piece_of)
    : m_costs(costs)
    , m_distance(distance)
    , m_piece_of(piece_of)
    , m_distances(piece_of.size(), unreached)
    , m_nodes(piece_of.size())
    , m_visits(piece_of.size(), 0)
  {}

  /// The band consists of the elements of the two pieces within `width` of `border`, on paths
  /// inside their own piece. Its elements at the inner ends stay, and those that
  /// `must_stay(element)`; if none stays in one of the pieces, nothing is moved, nor if a piece
  /// would be disconnected. Returns the elements that were moved.
  ///
  /// `border`: the elements of both pieces that are adjacent to the other one, or some of them.
  std::vector<Index> move_border(Index a, Index b, const std::vector<Index>& border, double width,
                                 std::function<bool(Index)> must_stay)
  {
    grow_band(border, width);
    Minimum_cut cut;
    std::vector<Index> moved;
    if (add_nodes(cut, a, must_stay)) {
      add_edges(cut, a, b);
      if (cut.improve())
        moved = move_elements(cut, a, b);
    }
    forget_band();
    return moved;
  }

  /// Whether a piece that was connected before elements left it still is: if and only if its
  /// elements adjacent to those are still connected to each other. Stops as soon as they are, so
  /// usually after a local search.
  bool is_connected(Index piece, const std::vector<Index>& moved)
  {
    const Index wanted = m_latest_visit + 1, reached = m_latest_visit + 2;
    m_latest_visit += 2;
    std::vector<Index> front;
    std::size_t missing = 0;
    for (const Index element : moved)
      for (const auto& step : m_costs.steps(element))
        if (m_piece_of[element] != piece && m_piece_of[step.face] == piece &&
            m_visits[step.face] != wanted) {
          m_visits[step.face] = wanted;
          front.assign(1, step.face);
          ++missing;
        }
    if (missing == 0)
      return true;
    m_visits[front[0]] = reached;
    --missing;
    for (std::size_t i = 0; i < front.size() && missing > 0; ++i)
      for (const auto& step : m_costs.steps(front[i]))
        if (m_piece_of[step.face] == piece && m_visits[step.face] != reached) {
          missing -= m_visits[step.face] == wanted;
          m_visits[step.face] = reached;
          front.push_back(step.face);
        }
    return missing == 0;
  }

private:
  static constexpr double unreached = (std::numeric_limits<double>::max)();

  void grow_band(const std::vector<Index>& border, double width)
  {
    for (const Index element : border)
      if (!is_in_band(element)) {
        m_band.push_back(element);
        m_distances[element] = 0;
      }
    find_shortest_paths(
      std::vector<Index>(m_band), m_distances, [](Index) { return true; },
      [&](Index element, const auto& enter) {
        for (const auto& step : m_costs.steps(element))
          if (m_piece_of[step.face] == m_piece_of[element])
            if (const double length = m_distance(element, step.face);
                m_distances[element] + length <= width) {
              const bool is_new = !is_in_band(step.face);
              if (enter(step.face, length) && is_new)
                m_band.push_back(step.face);
            }
      });
  }

  bool is_in_band(Index element) const { return m_distances[element] != unreached; }

  void forget_band()
  {
    for (const Index element : m_band)
      m_distances[element] = unreached;
    m_band.clear();
  }

  /// Returns whether there are elements that stay in both pieces.
  bool add_nodes(Minimum_cut& cut, Index a, std::function<bool(Index)> must_stay)
  {
    bool stays_in_a = false, stays_in_b = false;
    for (const Index element : m_band) {
      const bool is_in_a = m_piece_of[element] == a;
      const bool stays = is_at_inner_end(element) || must_stay(element);
      (is_in_a ? stays_in_a : stays_in_b) |= stays;
      m_nodes[element] = !stays ? cut.add_node(is_in_a) : is_in_a ? cut.source : cut.sink;
    }
    return stays_in_a && stays_in_b;
  }

  bool is_at_inner_end(Index element) const
  {
    for (const auto& step : m_costs.steps(element))
      if (!is_in_band(step.face) && m_piece_of[step.face] == m_piece_of[element])
        return true;
    return false;
  }

  void add_edges(Minimum_cut& cut, Index a, Index b) const
  {
    for (const Index element : m_band)
      for (const auto& step : m_costs.steps(element)) {
        const Index piece = m_piece_of[step.face];
        if (is_in_band(step.face)) {
          if (element < step.face)
            cut.add_edge(m_nodes[element], m_nodes[step.face], double(step.length));
        } else if (piece == a || piece == b)
          cut.add_edge(m_nodes[element], piece == a ? cut.source : cut.sink, double(step.length));
      }
  }

  /// Elements that a piece gains are connected to it (see `Minimum_cut`).
  std::vector<Index> move_elements(const Minimum_cut& cut, Index a, Index b)
  {
    std::vector<Index> moved;
    for (const Index element : m_band)
      if ((cut.is_on_source_side(m_nodes[element]) ? a : b) != m_piece_of[element])
        moved.push_back(element);
    const auto exchange = [&] {
      for (const Index element : moved)
        m_piece_of[element] = m_piece_of[element] == a ? b : a;
    };
    exchange();
    if (!is_connected(a, moved) || !is_connected(b, moved)) {
      exchange();
      moved.clear();
    }
    return moved;
  }

  const Dual_graph& m_costs;
  std::function<double(Index, Index)> m_distance;
  std::vector<Index>& m_piece_of;
  std::vector<double> m_distances; // of the elements of the band to the border
  std::vector<Index> m_nodes;      // of the elements of the band
  std::vector<Index> m_band;
  std::vector<Index> m_visits;
  Index m_latest_visit = 0;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPERFACETS_BORDER_CUT_H
