// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_BORDER_SMOOTHING_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_BORDER_SMOOTHING_H

#include <CGAL/Region_segmentation/internal/regions/Dual_graph.h>
#include <CGAL/Region_segmentation/internal/cuts/Minimum_cut.h>
#include <CGAL/Region_segmentation/internal/support/visitor.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Moves the borders between the pieces of segments, one pair of pieces after another. A piece is
/// connected across edges that are not constrained, at any time.
class Border_smoothing
{
public:
  using Index = Flat_mesh::Index;

  /// The two dual graphs have the same steps: `steps` with the distance of two faces, `weights` with the cost of a
  /// border between them. `piece_of_face` is changed; `label_of_piece`: two pieces of one segment have no border to be
  /// moved.
  Border_smoothing(const Flat_mesh& mesh, const Dual_graph& steps, const Dual_graph& weights,
                   std::vector<Index>& piece_of_face, const std::vector<Index>& label_of_piece)
    : m_steps(steps)
    , m_weights(weights)
    , m_piece_of(piece_of_face)
    , m_label_of_piece(label_of_piece)
    , m_distances(piece_of_face.size(), unreached)
    , m_nodes(piece_of_face.size(), Index(none))
    , m_visits(piece_of_face.size(), 0)
  {
    collect_borders();
    collect_constrained_edges(mesh);
  }

  /// `width(a, b)`: the width of the band between two pieces on each side.
  template <typename Width>
  void run(const Width& width, const Execution<>& execution)
  {
    Step_counter<CGAL::Sequential_tag> borders(execution, m_borders.size());
    for (auto first = m_borders.begin(); first != m_borders.end();) {
      const auto last = std::find_if(
        first, m_borders.end(), [&](const Border& b) { return b.a != first->a || b.b != first->b; });
      grow_band(first, last, width(first->a, first->b));
      move_border(first->a, first->b);
      forget_band();
      for (; first != last; ++first)
        borders.advance();
    }
  }

private:
  static constexpr Index none = (std::numeric_limits<Index>::max)();
  static constexpr double unreached = (std::numeric_limits<double>::max)();

  struct Border // a dual edge between two pieces a < b
  {
    Index a, b, face, neighbor;

    friend bool operator<(const Border& x, const Border& y)
    {
      return std::tie(x.a, x.b, x.face, x.neighbor) < std::tie(y.a, y.b, y.face, y.neighbor);
    }
  };
  using Border_iterator = std::vector<Border>::const_iterator;

  void collect_borders()
  {
    for (std::size_t f = 0; f < m_piece_of.size(); ++f)
      for (const auto& step : m_steps.steps(f)) {
        const Index a = m_piece_of[f], b = m_piece_of[step.face];
        if (a < b && m_label_of_piece[a] != m_label_of_piece[b])
          m_borders.push_back({a, b, Index(f), step.face});
      }
    std::sort(m_borders.begin(), m_borders.end());
  }

  void collect_constrained_edges(const Flat_mesh& mesh)
  {
    for (std::size_t e = 0; e < mesh.number_of_edges(); ++e)
      if (mesh.has_flag(e, Flat_mesh::CONSTRAINED)) {
        m_constrained.push_back({mesh.lower_face(e), mesh.higher_face(e)});
        m_constrained.push_back({mesh.higher_face(e), mesh.lower_face(e)});
      }
    std::sort(m_constrained.begin(), m_constrained.end());
  }

  /// The faces of the two pieces within `width` of their border, on paths inside their own piece. An
  /// earlier pair may have moved parts of the border; the remaining border is sufficient as a start.
  void grow_band(Border_iterator first, Border_iterator last, double width)
  {
    for (auto border = first; border != last; ++border)
      if (m_piece_of[border->face] == border->a && m_piece_of[border->neighbor] == border->b) {
        reach(border->face, 0);
        reach(border->neighbor, 0);
      }
    while (!m_front.empty()) {
      const auto [distance, face] = m_front.top();
      m_front.pop();
      if (distance > m_distances[face])
        continue;
      for (const auto& step : m_steps.steps(face))
        if (m_piece_of[step.face] == m_piece_of[face] && distance + double(step.length) <= width)
          reach(step.face, distance + double(step.length));
    }
  }

  void reach(Index face, double distance)
  {
    if (distance >= m_distances[face])
      return;
    if (m_distances[face] == unreached)
      m_band.push_back(face);
    m_distances[face] = distance;
    m_front.push({distance, face});
  }

  bool is_in_band(Index face) const { return m_distances[face] != unreached; }

  void forget_band()
  {
    for (Index face : m_band)
      m_distances[face] = unreached;
    m_band.clear();
  }

  void move_border(Index a, Index b)
  {
    Minimum_cut cut;
    bool a_is_tied = false, b_is_tied = false;
    for (Index face : m_band) {
      const bool is_in_a = m_piece_of[face] == a;
      const bool is_tied = must_stay(face, is_in_a ? b : a);
      (is_in_a ? a_is_tied : b_is_tied) |= is_tied;
      m_nodes[face] = !is_tied ? cut.add_node(is_in_a) : is_in_a ? cut.source : cut.sink;
    }
    if (!a_is_tied || !b_is_tied)
      return;
    for (Index face : m_band)
      for (const auto& step : m_weights.steps(face))
        if (!is_in_band(step.face)) {
          const Index piece = m_piece_of[step.face];
          if (piece == a || piece == b)
            cut.add_edge(m_nodes[face], piece == a ? cut.source : cut.sink, double(step.length));
        }
        else if (face < step.face)
          cut.add_edge(m_nodes[face], m_nodes[step.face], double(step.length));
    if (cut.improve())
      move_faces(cut, a, b);
  }

  /// Faces at the inner end of the band, and those that a constrained edge separates from the other
  /// segment.
  bool must_stay(Index face, Index other_piece) const
  {
    for (const auto& step : m_steps.steps(face))
      if (!is_in_band(step.face) && m_piece_of[step.face] == m_piece_of[face])
        return true;
    const Index other_label = m_label_of_piece[other_piece];
    for (auto edge = std::lower_bound(m_constrained.begin(), m_constrained.end(),
                                      std::make_pair(face, Index(0)));
         edge != m_constrained.end() && edge->first == face; ++edge)
      if (m_label_of_piece[m_piece_of[edge->second]] == other_label)
        return true;
    return false;
  }

  /// Moves the faces to their new sides, unless one of the pieces would be disconnected. Faces that a piece gains are
  /// connected to it (see `Minimum_cut`).
  void move_faces(const Minimum_cut& cut, Index a, Index b)
  {
    std::vector<Index> moved;
    for (Index face : m_band) {
      const Index piece = cut.is_on_source_side(m_nodes[face]) ? a : b;
      if (piece != m_piece_of[face])
        moved.push_back(face);
    }
    const auto exchange = [&] {
      for (Index face : moved)
        m_piece_of[face] = m_piece_of[face] == a ? b : a;
    };
    exchange();
    if (!is_connected(a, moved) || !is_connected(b, moved))
      exchange();
  }

  /// Whether a piece that was connected before faces left it still is: if and only if its faces next
  /// to those are still connected to each other. Stops as soon as they are, so usually after a local
  /// search.
  bool is_connected(Index piece, const std::vector<Index>& moved)
  {
    const Index wanted = m_latest_visit + 1, reached = m_latest_visit + 2;
    m_latest_visit += 2;
    std::vector<Index> front;
    std::size_t missing = 0;
    for (Index face : moved)
      for (const auto& step : m_steps.steps(face))
        if (m_piece_of[face] != piece && m_piece_of[step.face] == piece &&
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
      for (const auto& step : m_steps.steps(front[i]))
        if (m_piece_of[step.face] == piece && m_visits[step.face] != reached) {
          missing -= m_visits[step.face] == wanted;
          m_visits[step.face] = reached;
          front.push_back(step.face);
        }
    return missing == 0;
  }

  using Entry = std::pair<double, Index>; // distance, face

  const Dual_graph &m_steps, &m_weights;
  std::vector<Index>& m_piece_of;
  const std::vector<Index>& m_label_of_piece;
  std::vector<Border> m_borders;
  std::vector<std::pair<Index, Index>> m_constrained; // faces of constrained edges, both ways
  std::vector<double> m_distances;                    // of the faces of the band to the border
  std::vector<Index> m_nodes;                         // of the faces of the band
  std::vector<Index> m_band;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_front;
  std::vector<Index> m_visits;
  Index m_latest_visit = 0;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_BORDER_SMOOTHING_H
