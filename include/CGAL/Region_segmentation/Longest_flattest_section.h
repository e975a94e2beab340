// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_LONGEST_FLATTEST_SECTION_H
#define CGAL_REGION_SEGMENTATION_LONGEST_FLATTEST_SECTION_H

#include <CGAL/Region_segmentation/internal/region_graph_iterators.h>
#include <CGAL/Region_segmentation/internal/share.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// chooses, among the sections of a region, the one to merge across: long and flat compared with the
/// others.
///
/// The section \f$i\f$ has the largest sum over the region's other sections \f$j\f$ of
/// \f[ P_{ij} = \beta \frac{L_i}{L_i + L_j} + (1 - \beta) \frac{A_i}{A_i + A_j}, \f]
/// \f$L\f$ the length and \f$A\f$ the mean dihedral angle of a section; 0/0 is 1/2; the lower neighbor
/// id of equal sums. Sections that are not mergeable count as \f$j\f$ alone.
///
/// Complexity: O(d log d + d p) for d sections, p of which are not outdone by another one in both
/// length and angle: usually a few.
///
/// Source: Yang et al. 2014, eq. 3.
class Longest_flattest_section
{
public:
  /// `beta`: the weight of the length, in [0, 1]; that of the angle is 1 - beta
  explicit Longest_flattest_section(double beta = 0.1) : m_beta(beta) {}

  /// The section, seen from the region; empty if the region has none that is mergeable.
  template <typename Graph>
  std::optional<Section_descriptor> operator()(const Graph& graph, std::uint32_t region)
  {
    read_sections(graph, region);
    const Item* best = nullptr;
    double best_sum = 0;
    for (std::size_t i : front()) {
      const double sum = sum_over_others(i);
      const Item& item = m_items[i];
      if (!best || sum > best_sum || (sum == best_sum && item.neighbor < best->neighbor)) {
        best = &item;
        best_sum = sum;
      }
    }
    return best ? std::optional<Section_descriptor>(best->section) : std::nullopt;
  }

private:
  struct Item
  {
    double length, angle;
    std::uint32_t neighbor;
    Section_descriptor section;
  };

  template <typename Graph>
  void read_sections(const Graph& graph, std::uint32_t region)
  {
    m_items.clear();
    m_mergeable.clear();
    for (Section_descriptor s : graph.sections(region)) {
      if (graph.is_mergeable(s))
        m_mergeable.push_back(m_items.size());
      m_items.push_back({graph[s].length, graph[s].mean_angle(), graph.target(s), s});
    }
  }

  /// P_ij increases with length and with angle, so a section that is outdone in both cannot win: what
  /// remains is found by a scan in the order of length.
  const std::vector<std::size_t>& front()
  {
    std::sort(m_mergeable.begin(), m_mergeable.end(), [this](std::size_t a, std::size_t b) {
      const Item &x = m_items[a], &y = m_items[b];
      if (x.length != y.length)
        return x.length > y.length;
      return x.angle != y.angle ? x.angle > y.angle : x.neighbor < y.neighbor;
    });
    m_front.clear();
    for (std::size_t i : m_mergeable)
      if (m_front.empty() || m_items[i].angle > m_items[m_front.back()].angle)
        m_front.push_back(i);
    return m_front;
  }

  double sum_over_others(std::size_t i) const
  {
    double sum = 0;
    for (std::size_t j = 0; j < m_items.size(); ++j)
      if (j != i)
        sum += m_beta * internal::share(m_items[i].length, m_items[j].length) +
               (1 - m_beta) * internal::share(m_items[i].angle, m_items[j].angle);
    return sum;
  }

  double m_beta;
  std::vector<Item> m_items;
  std::vector<std::size_t> m_mergeable, m_front;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_LONGEST_FLATTEST_SECTION_H
