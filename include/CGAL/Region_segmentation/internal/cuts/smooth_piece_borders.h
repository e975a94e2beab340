// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_SMOOTH_PIECE_BORDERS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_SMOOTH_PIECE_BORDERS_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/cuts/Border_cut.h>
#include <CGAL/Region_segmentation/internal/regions/Dual_graph.h>
#include <CGAL/Region_segmentation/internal/support/Function_ref.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Moves the borders between the pieces of segments, one pair of pieces after another. A piece is
/// connected across edges that are not constrained, at any time.
///
/// `costs`: of the borders between adjacent faces, `constrained`: which faces are adjacent across
/// constrained edges; `width(a, b)`: of the band between two pieces on each side. `piece_of` is
/// changed; `label_of_piece`: two pieces of one segment have no border to be moved.
inline void smooth_piece_borders(const Dual_graph& costs, const Dual_graph& constrained,
                                 Function_ref<double(Surface::Index, Surface::Index)> distance,
                                 Function_ref<double(Surface::Index, Surface::Index)> width,
                                 const std::vector<Surface::Index>& label_of_piece,
                                 std::vector<Surface::Index>& piece_of, const Execution& execution)
{
  using Index = Surface::Index;
  using Pair = std::pair<Index, Index>;
  std::vector<std::pair<Pair, Pair>> sides; // two pieces a < b, and a face of each
  for (Index f = 0; f < piece_of.size(); ++f)
    for (const auto& step : costs.steps(f)) {
      const Index a = piece_of[f], b = piece_of[step.face];
      if (a < b && label_of_piece[a] != label_of_piece[b])
        sides.push_back({{a, b}, {f, step.face}});
    }
  std::sort(sides.begin(), sides.end());

  Border_cut cut(costs, distance, piece_of);
  Step_counter counter(execution, sides.size());
  for (auto side = sides.begin(); side != sides.end();) {
    const Pair pieces = side->first;
    std::vector<Index> border;
    for (; side != sides.end() && side->first == pieces; ++side) {
      // An earlier pair may have moved parts of the border; the remaining border is sufficient as a
      // start.
      const auto [face, neighbor] = side->second;
      if (Pair(piece_of[face], piece_of[neighbor]) == pieces)
        border.insert(border.end(), {face, neighbor});
      counter.advance();
    }
    const auto is_separated = [&](Index face) { // by a constrained edge from the other segment
      const bool is_in_first = piece_of[face] == pieces.first;
      const Index other_label = label_of_piece[is_in_first ? pieces.second : pieces.first];
      const auto steps = constrained.steps(face);
      return std::any_of(steps.begin(), steps.end(), [&](const auto& step) {
        return label_of_piece[piece_of[step.face]] == other_label;
      });
    };
    cut.move_border(pieces.first, pieces.second, border, width(pieces.first, pieces.second),
                    is_separated);
  }
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_CUTS_SMOOTH_PIECE_BORDERS_H
