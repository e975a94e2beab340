// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_BORDER_SHORTENING_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_BORDER_SHORTENING_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/regions/Dual_graph.h>

#include <cstddef>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Shortens the borders of regions: elements with a single neighbor in their own region move to the
/// region to which their border costs more than that to their neighbor, the largest gain first, as
/// long as there are any. Such an element is an end of its region, so regions stay connected, and
/// none becomes empty.
///
/// O(E log E) in practice, E the number of adjacent pairs.
class Border_shortening
{
  using Index = Dual_graph::Index;

public:
  /// `costs`: of the borders between adjacent elements
  Border_shortening(const Dual_graph& costs, const Partition& regions)
    : m_costs(costs)
    , m_region_of(regions.begin(), regions.end())
  {
    for (std::size_t i = 0; i < m_region_of.size(); ++i)
      push(Index(i));
    while (!m_moves.empty()) {
      const Move move = m_moves.top();
      m_moves.pop();
      if (best_move(move.element) == move)
        make(move);
    }
  }

  Partition take_regions() { return Partition::from_labels(std::exchange(m_region_of, {})); }

private:
  /// Of the cost, a part of that of all borders of the element: smaller ones are rounding.
  static constexpr double smallest_gain = 1e-3;

  struct Move
  {
    double gain;
    Index element, to;

    friend bool operator==(const Move& a, const Move& b)
    {
      return a.gain == b.gain && a.element == b.element && a.to == b.to;
    }
    friend bool operator<(const Move& a, const Move& b)
    {
      return a.gain != b.gain ? a.gain < b.gain : a.element > b.element;
    }
  };

  /// The gain is 0 if there is none. Of several regions, the lower one.
  Move best_move(Index element)
  {
    const Index own = m_region_of[element];
    std::size_t neighbors_inside = 0;
    for (const auto& step : m_costs.steps(element))
      neighbors_inside += m_region_of[step.face] == own;
    Move best{0, element, own};
    if (neighbors_inside != 1) // most elements
      return best;
    double all = 0, inside = 0;
    m_outside.clear();
    for (const auto& step : m_costs.steps(element)) {
      all += double(step.length);
      if (const Index region = m_region_of[step.face]; region != own)
        add_outside(region, double(step.length));
      else
        inside = double(step.length);
    }
    for (const auto& [region, cost] : m_outside) {
      const double gain = cost - inside;
      if (gain > smallest_gain * all &&
          (gain > best.gain || (gain == best.gain && region < best.to)))
        best = {gain, element, region};
    }
    return best;
  }

  void add_outside(Index region, double cost)
  {
    for (auto& [other, sum] : m_outside)
      if (other == region) {
        sum += cost;
        return;
      }
    m_outside.push_back({region, cost});
  }

  void make(const Move& move)
  {
    m_region_of[move.element] = move.to;
    push(move.element);
    for (const auto& step : m_costs.steps(move.element))
      push(step.face);
  }

  void push(Index element)
  {
    if (const Move move = best_move(element); move.gain > 0)
      m_moves.push(move);
  }

  const Dual_graph& m_costs;
  std::vector<Index> m_region_of;
  std::vector<std::pair<Index, double>> m_outside; // region and cost of the borders of an element
  std::priority_queue<Move> m_moves;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_BORDER_SHORTENING_H
