// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_BORDER_SMOOTHING_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_BORDER_SMOOTHING_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/cuts/Border_cut.h>
#include <CGAL/Region_segmentation/internal/regions/Dual_graph.h>
#include <CGAL/Region_segmentation/internal/support/Function_ref.h>

#include <algorithm>
#include <cstddef>
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
  using Index = Surface::Index;

  /// `costs`: of the borders between adjacent faces. `piece_of_face` is changed; `label_of_piece`:
  /// two pieces of one segment have no border to be moved.
  Border_smoothing(const Surface& surface, const Constraints& constraints, const Dual_graph& costs,
                   Function_ref<double(Index, Index)> distance, std::vector<Index>& piece_of_face,
                   const std::vector<Index>& label_of_piece)
    : m_piece_of(piece_of_face)
    , m_label_of_piece(label_of_piece)
    , m_constrained(
        surface, [&](std::size_t a) { return constraints[a]; }, [](std::size_t) { return 0; })
    , m_cut(costs, distance, piece_of_face)
  {
    collect_borders(costs);
  }

  /// `width(a, b)`: the width of the band between two pieces on each side.
  void run(Function_ref<double(Index, Index)> width, const Execution& execution)
  {
    Step_counter borders(execution, m_borders.size());
    for (auto first = m_borders.begin(); first != m_borders.end();) {
      const Index a = first->a, b = first->b;
      std::vector<Index> border;
      for (; first != m_borders.end() && first->a == a && first->b == b; ++first) {
        // An earlier pair may have moved parts of the border; the remaining border is sufficient as
        // a start.
        if (m_piece_of[first->face] == a && m_piece_of[first->neighbor] == b)
          border.insert(border.end(), {first->face, first->neighbor});
        borders.advance();
      }
      m_cut.move_border(a, b, border, width(a, b), [&](Index face) {
        return is_separated(face, m_label_of_piece[m_piece_of[face] == a ? b : a]);
      });
    }
  }

private:
  struct Border // a dual edge between two pieces a < b
  {
    Index a, b, face, neighbor;

    friend bool operator<(const Border& x, const Border& y)
    {
      return std::tie(x.a, x.b, x.face, x.neighbor) < std::tie(y.a, y.b, y.face, y.neighbor);
    }
  };

  void collect_borders(const Dual_graph& costs)
  {
    for (std::size_t f = 0; f < m_piece_of.size(); ++f)
      for (const auto& step : costs.steps(f)) {
        const Index a = m_piece_of[f], b = m_piece_of[step.face];
        if (a < b && m_label_of_piece[a] != m_label_of_piece[b])
          m_borders.push_back({a, b, Index(f), step.face});
      }
    std::sort(m_borders.begin(), m_borders.end());
  }

  /// Whether a constrained edge separates a face from a segment.
  bool is_separated(Index face, Index label) const
  {
    for (const auto& step : m_constrained.steps(face))
      if (m_label_of_piece[m_piece_of[step.face]] == label)
        return true;
    return false;
  }

  const std::vector<Index>& m_piece_of;
  const std::vector<Index>& m_label_of_piece;
  std::vector<Border> m_borders;
  const Dual_graph m_constrained; // across constrained edges
  Border_cut m_cut;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_BORDER_SMOOTHING_H
