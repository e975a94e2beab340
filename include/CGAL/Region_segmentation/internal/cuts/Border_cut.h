// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_BORDER_CUT_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_BORDER_CUT_H

#include <CGAL/Region_segmentation/internal/cuts/Minimum_cut.h>
#include <CGAL/Region_segmentation/internal/regions/Dual_graph.h>
#include <CGAL/Region_segmentation/internal/support/Function_ref.h>
#include <CGAL/Region_segmentation/internal/support/shortest_paths.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Moves the border between two pieces of a mesh to a minimum cut in a band around it. Elements are
/// faces, or patches; a piece that was connected still is.
class Border_cut
{
public:
  using Index = Dual_graph::Index;

  /// `costs`: of the borders between adjacent elements; `distance(i, j)`: of two of these, is kept
  /// by reference; `piece_of`: by element, is changed by `move_border()`
  Border_cut(const Dual_graph& costs, Function_ref<double(Index, Index)> distance,
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
                                 Function_ref<bool(Index)> must_stay)
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
  bool add_nodes(Minimum_cut& cut, Index a, Function_ref<bool(Index)> must_stay)
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
  Function_ref<double(Index, Index)> m_distance;
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

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_BORDER_CUT_H
