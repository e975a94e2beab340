// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TWO_STEP_LEAST_COMPACT_REGION_FIRST_H
#define CGAL_REGION_SEGMENTATION_TWO_STEP_LEAST_COMPACT_REGION_FIRST_H

#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Two_step/longest_flattest_section.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// The planarity \f$\rho = c^2 / (4 \pi s)\f$ of a region of perimeter \f$c\f$ and area \f$s\f$
/// (paper, eq. 2): 1 for a disc, more for any other plane shape, 0 for a region without neighbors,
/// infinite where the area is 0. It has no unit.
inline double planarity(const Region_geometry& region)
{
  if (region.area == 0)
    return std::numeric_limits<double>::infinity();
  return region.perimeter * region.perimeter / (4 * CGAL_PI * region.area);
}

/// \ingroup PkgRegionSegmentationPolicies
/// Step two of the paper: merges a small region whose shape is far from a disc next, across the
/// section that `longest_flattest_section()` chooses. A model of `MergingPolicy`.
///
/// The region \f$i\f$ that has a section and the largest sum over all other regions \f$j\f$ of
/// \f[ P_j(C_i) = 1 - \gamma \frac{e^{-\rho_i}}{e^{-\rho_i} + e^{-\rho_j}}
///              - (1 - \gamma) \frac{s_i}{s_i + s_j}, \f]
/// \f$s\f$ the area and \f$\rho\f$ the planarity (paper, eq. 4); the lower id of equal sums. What
/// \f$P_j\f$ subtracts from 1 is rounded to a multiple of \f$2^{-36}\f$, so that rounding does not
/// decide between regions of equal area and planarity. The cost of a merge is 1 minus the mean of
/// \f$P_j\f$: in [0, 1], low for an insignificant region.
///
/// Complexity: O(R^2) for R regions at the start, O(R) per merge, and the choice of the section.
class Least_compact_region_first
{
public:
  /// `beta`: see `longest_flattest_section()`; `gamma`: the weight of planarity, in [0, 1]; that of
  /// the area is 1 - gamma
  /// \throws Invalid_method if a constant is not in its range
  explicit Least_compact_region_first(double beta = 0.1, double gamma = 0.6)
    : m_beta(beta)
    , m_gamma(gamma)
  {
    internal::check_constant("Least_compact_region_first: beta", beta, 0, 1);
    internal::check_constant("Least_compact_region_first: gamma", gamma, 0, 1);
  }

  template <typename Graph>
  void initialize(const Graph& graph)
  {
    const auto [begin, end] = vertices(graph);
    m_regions.assign(begin, end);
    m_shapes.resize(graph.index_bound_of_regions());
    m_sums.resize(graph.index_bound_of_regions());
    for (const std::uint32_t i : m_regions)
      m_shapes[i] = shape(graph[i]);
    for (const std::uint32_t i : m_regions)
      m_sums[i] = sum_over_regions(i);
  }

  template <typename Graph>
  std::optional<Merge_candidate> next(const Graph& graph)
  {
    // The largest sum of P_j is the smallest one of what P_j subtracts from 1.
    const auto is_less = [this](auto i, auto j) { return m_sums[i] < m_sums[j]; };
    while (!m_regions.empty()) {
      const auto i = *std::min_element(m_regions.begin(), m_regions.end(), is_less);
      if (m_sums[i] == without_section)
        break;
      if (const auto section = longest_flattest_section(graph, i, m_beta)) {
        const double others = double((std::max)(m_regions.size(), std::size_t(2)) - 1);
        return Merge_candidate{*section, (m_sums[i] - 0.5) / others};
      }
      m_sums[i] = without_section;
    }
    return std::nullopt;
  }

  /// Changes the sums by the terms of the two regions and of the merged one: O(R), where summing
  /// anew would take O(R^2).
  template <typename Graph>
  void on_merge(const Graph& graph, const typename Graph::Merge& merge)
  {
    const Shape kept = m_shapes[merge.kept], removed = m_shapes[merge.removed],
                merged = shape(graph[merge.kept]);
    m_shapes[merge.kept] = merged;
    m_regions.erase(std::lower_bound(m_regions.begin(), m_regions.end(), merge.removed));
    for (const std::uint32_t i : m_regions)
      m_sums[i] += term(m_shapes[i], merged) - term(m_shapes[i], kept) - term(m_shapes[i], removed);
    m_sums[merge.kept] = sum_over_regions(merge.kept);
  }

private:
  static constexpr double without_section = std::numeric_limits<double>::infinity();

  struct Shape
  {
    double area, planarity, compactness; // s, rho, e^-rho
  };

  static Shape shape(const Region_geometry& region)
  {
    const double rho = planarity(region);
    return {region.area, rho, std::exp(-rho)};
  }

  /// What P_j(C_i) subtracts from 1, rounded to a multiple of 2^-36, the last digit of a double
  /// from 2^16 on. Sums of up to 2^17 such terms are exact, whether they are updated or added anew.
  double term(const Shape& i, const Shape& j) const
  {
    constexpr double two_to_16 = 65536;
    const double share_of_i = m_gamma * share_of_compactness(i, j) +
                              (1 - m_gamma) * internal::share(i.area, j.area);
    return (share_of_i + two_to_16) - two_to_16;
  }

  /// e^-rho_i / (e^-rho_i + e^-rho_j), for planarities up to infinity.
  static double share_of_compactness(const Shape& i, const Shape& j)
  {
    const double sum = i.compactness + j.compactness;
    if (sum > 1e-290) // the exponentials have all their digits
      return i.compactness / sum;
    return i.planarity == j.planarity ? 0.5 : 1 / (1 + std::exp(i.planarity - j.planarity));
  }

  /// The sum of the terms over all regions, with 1/2 for the region itself.
  double sum_over_regions(std::uint32_t i) const
  {
    double sum = 0;
    for (const std::uint32_t j : m_regions)
      sum += term(m_shapes[i], m_shapes[j]);
    return sum;
  }

  double m_beta, m_gamma;
  std::vector<std::uint32_t> m_regions; // the regions that are not merged away, ascending
  std::vector<Shape> m_shapes;          // by region
  std::vector<double> m_sums;           // by region; exact
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_TWO_STEP_LEAST_COMPACT_REGION_FIRST_H
