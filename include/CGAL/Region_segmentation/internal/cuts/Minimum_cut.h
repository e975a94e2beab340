// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_MINIMUM_CUT_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_MINIMUM_CUT_H

#include <CGAL/Region_segmentation/internal/cuts/Flow_network.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A graph whose nodes lie on two sides, source and sink, and the minimum cut between its two
/// terminals; of several, one that moves the fewest nodes. Boost.Graph finds the flow.
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

  struct Edge
  {
    Node lower, higher;
    double capacity;
  };

  /// Moving a node costs 1, and moving all less than the unit of the capacities. Boost's algorithm
  /// does not support parallel edges between a node and a terminal: they are united.
  void find_flow(std::vector<boost::default_color_type>& colors) const
  {
    const std::size_t nodes = m_is_on_source_side.size();
    double total = 0;
    for (const Edge& e : m_edges)
      total += e.capacity;
    const int exponent = total > 0 ? 50 - std::ilogb(total) - std::ilogb(double(nodes)) : 0;
    const auto integral = [&](double capacity) {
      const auto rounded = Capacity(std::llround(std::scalbn(capacity, exponent)));
      return (std::max)(Capacity(1), rounded) * Capacity(nodes);
    };

    Flow_network<Capacity> network(nodes, m_edges.size() + 2 * nodes);
    std::vector<std::array<Capacity, 2>> to_terminals(nodes, {0, 0});
    for (const Edge& e : m_edges)
      if (e.lower <= sink)
        to_terminals[e.higher][e.lower] += integral(e.capacity);
      else
        network.add_edge(e.lower, e.higher, integral(e.capacity));
    for (Node n = sink + 1; n < nodes; ++n) {
      to_terminals[n][m_is_on_source_side[n] ? source : sink] += 1;
      for (Node terminal : {source, sink})
        if (to_terminals[n][terminal] > 0)
          network.add_edge(terminal, n, to_terminals[n][terminal]);
    }
    network.run(source, sink, colors);
  }

  std::vector<std::uint8_t> m_is_on_source_side;
  std::vector<Edge> m_edges;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_MINIMUM_CUT_H
