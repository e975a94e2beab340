// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPERFACETS_INTERNAL_BORDER_CUT_H
#define CGAL_REGION_SEGMENTATION_SUPERFACETS_INTERNAL_BORDER_CUT_H

#include <CGAL/Region_segmentation/Graph/internal/Dual_graph.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
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
/// terminals. Of several minimum cuts, `improve()` takes one that moves the fewest nodes, and of
/// these the one with the fewest nodes on the side of the source.
///
/// Boost.Graph finds the flow in a graph of compressed rows: with a `boost::adjacency_list`, a
/// `Segmenter` with the default method takes 5 % more instructions, and `segment()` 1.5 %.
///
/// Capacities are rounded to integers whose sum is about 2^51 divided by the number of nodes. Sums
/// of integers are exact, so the cut does not depend on the order of nodes and edges. No rounded
/// capacity is 0. So each node is connected to the terminal of its new side by nodes of that side,
/// if every node has a path to both terminals.
class Minimum_cut
{
public:
  using Node = std::uint32_t;
  static constexpr Node source = 0, sink = 1;

  Node add_node(bool is_on_source_side)
  {
    m_is_on_source_side.push_back(is_on_source_side);
    return Node(m_is_on_source_side.size() - 1);
  }

  /// Ignores loops and edges between the two terminals, which have no effect.
  void add_edge(Node a, Node b, double capacity)
  {
    if (a != b && (std::max)(a, b) > sink)
      m_edges.push_back({(std::min)(a, b), (std::max)(a, b), capacity});
  }

  /// Moves nodes to the other side where that lowers the capacity of the cut; returns whether any
  /// node moved.
  bool improve()
  {
    const std::vector<char> before = std::exchange(m_is_on_source_side, nodes_on_source_side());
    return m_is_on_source_side != before;
  }

  bool is_on_source_side(Node n) const { return m_is_on_source_side[n] != 0; }

private:
  using Capacity = std::int64_t;

  struct Edge
  {
    Node lower, higher;
    double capacity;
  };

  struct Arc
  {
    Node index; ///< 2e and 2e + 1 for the two directions of edge e

    Arc(Node index_ = 0)
      : index(index_)
    {}
  };

  using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, Arc,
                                                   boost::no_property, Node, Node>;

  struct Network
  {
    std::vector<std::pair<Node, Node>> arcs; // start, end
    std::vector<Capacity> capacities;        // by arc

    void add(Node a, Node b, Capacity capacity)
    {
      arcs.insert(arcs.end(), {{a, b}, {b, a}});
      capacities.insert(capacities.end(), 2, capacity);
    }
  };

  /// The network with integral capacities. To move a node costs 1, and to move all nodes less than
  /// the unit of the given capacities. The edges between a node and a terminal are united, since
  /// Boost's algorithm does not support parallel ones.
  Network network() const
  {
    const std::size_t nodes = m_is_on_source_side.size();
    double total = 0;
    for (const Edge& e : m_edges)
      total += e.capacity;
    const int exponent = total > 0 ? 50 - std::ilogb(total) - std::ilogb(double(nodes)) : 0;
    Network result;
    std::vector<std::array<Capacity, 2>> to_terminals(nodes, {0, 0});
    for (const auto& [lower, higher, capacity] : m_edges) {
      const auto rounded = Capacity(std::llround(std::scalbn(capacity, exponent)));
      const Capacity integral = (std::max)(Capacity(1), rounded) * Capacity(nodes);
      if (lower <= sink)
        to_terminals[higher][lower] += integral;
      else
        result.add(lower, higher, integral);
    }
    for (Node n = sink + 1; n < nodes; ++n) {
      to_terminals[n][m_is_on_source_side[n] ? source : sink] += 1;
      for (const Node terminal : {source, sink})
        if (to_terminals[n][terminal] > 0)
          result.add(terminal, n, to_terminals[n][terminal]);
    }
    return result;
  }

  /// By node, whether it is on the side of the source in every minimum cut.
  std::vector<char> nodes_on_source_side() const
  {
    const auto [arcs, capacities] = network();
    const std::size_t nodes = m_is_on_source_side.size();
    const Graph graph(boost::edges_are_unsorted_multi_pass, arcs.begin(), arcs.end(),
                      boost::counting_iterator<Node>(0), Node(nodes));
    std::vector<boost::graph_traits<Graph>::edge_descriptor> reverse(arcs.size());
    for (auto range = edges(graph); range.first != range.second; ++range.first)
      reverse[graph[*range.first].index ^ 1] = *range.first;
    std::vector<Capacity> residual(arcs.size());
    std::vector<boost::default_color_type> colors(nodes);
    const auto arc = get(&Arc::index, graph);
    const auto node = get(boost::vertex_index, graph);
    boost::boykov_kolmogorov_max_flow(
      graph, boost::make_iterator_property_map(capacities.begin(), arc),
      boost::make_iterator_property_map(residual.begin(), arc),
      boost::make_iterator_property_map(reverse.begin(), arc),
      boost::make_iterator_property_map(colors.begin(), node), node, source, sink);
    std::vector<char> result;
    for (const boost::default_color_type color : colors)
      result.push_back(color == boost::black_color);
    return result;
  }

  std::vector<char> m_is_on_source_side{1, 0};
  std::vector<Edge> m_edges;
};

/// Moves the border between two pieces of a mesh to a minimum cut in a band around it. The elements
/// of pieces are faces or patches. A piece that was connected still is afterwards.
class Border_cut
{
public:
  using Index = Dual_graph::Index;

  /// `costs`: of the borders between adjacent elements; `distance(i, j)`: between two adjacent
  /// elements; `piece_of`: by element, changed by `move_border()`
  Border_cut(const Dual_graph& costs, std::function<double(Index, Index)> distance,
             std::vector<Index>& piece_of)
    : m_costs(costs)
    , m_distance(std::move(distance))
    , m_piece_of(piece_of)
    , m_distances(piece_of.size(), unreached)
    , m_nodes(piece_of.size())
    , m_visits(piece_of.size(), 0)
  {}

  /// The band consists of the elements of the two pieces within `width` of `border`, measured along
  /// paths inside their own piece. Elements at the inner ends of the band keep their piece, and so
  /// do those for which `must_stay(element)`. Nothing is moved if the width is less than
  /// `narrowest_band`, if no element of the band stays in one of the pieces, or if a piece would be
  /// disconnected. Returns the elements that were moved.
  ///
  /// `border`: elements of either piece that are adjacent to the other piece, all or some of them.
  std::vector<Index> move_border(Index a, Index b, const std::vector<Index>& border, double width,
                                 std::function<bool(Index)> must_stay)
  {
    std::vector<Index> moved;
    if (!(width >= narrowest_band))
      return moved;
    grow_band(border, width);
    Minimum_cut cut;
    if (add_nodes(cut, a, must_stay)) {
      add_edges(cut, a, b);
      if (cut.improve())
        moved = move_elements(cut, a, b);
    }
    for (const Index element : std::exchange(m_band, {}))
      m_distances[element] = unreached;
    return moved;
  }

  /// Whether a piece that was connected before `moved` elements left it still is: whether its
  /// elements adjacent to those that left are connected to each other. The search stops as soon as
  /// it has reached all of them, which it usually does nearby.
  bool is_connected(Index piece, const std::vector<Index>& moved)
  {
    const Index wanted = ++m_latest_visit, reached = ++m_latest_visit;
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
    if (missing <= 1)
      return true;
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
  /// A narrower band is not moved in: far from the origin, rounding of distances reaches this
  /// share, and the band of a piece without area is narrower.
  static constexpr double narrowest_band = 1e-6;
  static constexpr double unreached = (std::numeric_limits<double>::max)();

  void grow_band(const std::vector<Index>& border, double width)
  {
    find_shortest_paths(
      border, m_distances,
      [&](Index element) {
        m_band.push_back(element);
        return true;
      },
      [&](Index element, const auto& enter) {
        for (const auto& step : m_costs.steps(element))
          if (m_piece_of[step.face] == m_piece_of[element])
            if (const double length = m_distance(element, step.face);
                m_distances[element] + length <= width)
              enter(step.face, length);
      });
  }

  bool is_in_band(Index element) const { return m_distances[element] != unreached; }

  /// Returns whether elements of both pieces stay.
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
    const auto steps = m_costs.steps(element);
    return std::any_of(steps.begin(), steps.end(), [&](const auto& step) {
      return !is_in_band(step.face) && m_piece_of[step.face] == m_piece_of[element];
    });
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

  /// Moves elements to the side of the cut on which they are, unless that disconnects a piece. (The
  /// elements that a piece gains are connected to it: see `Minimum_cut`.)
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

#endif // CGAL_REGION_SEGMENTATION_SUPERFACETS_INTERNAL_BORDER_CUT_H
