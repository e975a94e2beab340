// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_LEAST_COMPACT_REGION_FIRST_H
#define CGAL_REGION_SEGMENTATION_LEAST_COMPACT_REGION_FIRST_H

#include <CGAL/Region_segmentation/Longest_flattest_section.h>
#include <CGAL/Region_segmentation/Merge_candidate.h>
#include <CGAL/Region_segmentation/internal/share.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// The planarity \f$\rho = c^2 / (4 \pi s)\f$ of a region of perimeter \f$c\f$ and area \f$s\f$: 1 for
/// a disc, more for any other plane shape, 0 for a region without neighbors, infinite where the area is
/// 0. It has no unit.
///
/// Source: Yang et al. 2014, eq. 2.
template <typename RegionData>
double planarity(const RegionData& region)
{
  if (region.area == 0)
    return std::numeric_limits<double>::infinity();
  return region.perimeter * region.perimeter / (4 * CGAL_PI * region.area);
}

/// \ingroup PkgRegionSegmentationPolicies
/// Step two of the paper: a small region far from a disc goes next, across the section that
/// `Longest_flattest_section` chooses. A model of `RegionMergingPolicy`.
///
/// The region \f$i\f$ that has a section and the largest sum over all other regions \f$j\f$ of
/// \f[ P_j(C_i) = 1 - \gamma \frac{e^{-\rho_i}}{e^{-\rho_i} + e^{-\rho_j}}
///              - (1 - \gamma) \frac{s_i}{s_i + s_j}, \f]
/// \f$s\f$ the area and \f$\rho\f$ the planarity; the lower id of equal sums. The cost of a merge is 1
/// less the mean of these terms: in [0, 1], low for a region that hardly counts.
///
/// Complexity: O(R) a merge, and the choice of the section.
///
/// Source: Yang et al. 2014, eq. 4.
class Least_compact_region_first
{
public:
  /// `beta`: see `Longest_flattest_section`; `gamma`: the weight of planarity, in [0, 1], that of the
  /// area is 1 - gamma
  explicit Least_compact_region_first(double beta = 0.1, double gamma = 0.6)
    : m_section_of(beta), m_gamma(gamma)
  {}

  template <typename Graph>
  void initialize(const Graph& graph, std::size_t /* number_of_segments */)
  {
    m_items.clear();
    for (auto range = vertices(graph); range.first != range.second; ++range.first)
      m_items.push_back(item(graph, *range.first));
    for (Item& i : m_items)
      i.weight = weight(i);
  }

  template <typename Graph>
  std::optional<Merge_candidate> next(const Graph& graph)
  {
    while (true) {
      const auto best = std::min_element(m_items.begin(), m_items.end(), goes_before);
      if (best == m_items.end() || best->is_settled)
        return std::nullopt;
      if (const auto section = m_section_of(graph, best->region)) {
        const double others = double((std::max)(m_items.size(), std::size_t(2)) - 1);
        return Merge_candidate{*section, (best->weight - 0.5) / others};
      }
      best->is_settled = true; // it never gets a section, but goes on to count for the others
    }
  }

  template <typename Graph>
  void on_merge(const Graph& graph, const typename Graph::Merge& merge)
  {
    const auto kept = find(merge.kept), removed = find(merge.removed);
    const Item before = *kept, gone = *removed, after = item(graph, merge.kept);
    *kept = after;
    m_items.erase(removed);
    for (Item& i : m_items)
      i.weight += term(i, after) - term(i, before) - term(i, gone);
    find(merge.kept)->weight = weight(after);
  }

private:
  struct Item
  {
    std::uint32_t region;
    bool is_settled;
    double area, planarity;
    double weight; // the sum over all regions j, itself included as 1/2, of what P_j subtracts from 1
  };

  template <typename Graph>
  static Item item(const Graph& graph, std::uint32_t region)
  {
    return {region, false, graph[region].area, planarity(graph[region]), 0};
  }

  /// The largest sum of P_j is the smallest sum of what it subtracts.
  static bool goes_before(const Item& a, const Item& b)
  {
    if (a.is_settled != b.is_settled)
      return b.is_settled;
    return a.weight != b.weight ? a.weight < b.weight : a.region < b.region;
  }

  double term(const Item& i, const Item& j) const
  {
    return m_gamma * softmax(i.planarity, j.planarity) +
           (1 - m_gamma) * internal::share(i.area, j.area);
  }

  double weight(const Item& i) const
  {
    return std::accumulate(m_items.begin(), m_items.end(), 0.0, [&](double sum, const Item& j) {
      return sum + term(i, j);
    });
  }

  /// e^-a / (e^-a + e^-b) with an exponential that is at most 1, for a and b up to infinity.
  static double softmax(double a, double b)
  {
    if (a == b)
      return 0.5;
    const double e = std::exp(-std::abs(a - b));
    return a < b ? 1 / (1 + e) : e / (1 + e);
  }

  std::vector<Item>::iterator find(std::uint32_t region)
  {
    return std::lower_bound(m_items.begin(), m_items.end(), region,
                            [](const Item& i, std::uint32_t r) { return i.region < r; });
  }

  Longest_flattest_section m_section_of;
  double m_gamma;
  std::vector<Item> m_items; // by region
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_LEAST_COMPACT_REGION_FIRST_H
