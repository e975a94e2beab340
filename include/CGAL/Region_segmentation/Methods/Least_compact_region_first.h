// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_LEAST_COMPACT_REGION_FIRST_H
#define CGAL_REGION_SEGMENTATION_METHODS_LEAST_COMPACT_REGION_FIRST_H

#include <CGAL/Region_segmentation/Methods/Longest_flattest_section.h>
#include <CGAL/Region_segmentation/Graph/Merge_candidate.h>
#include <CGAL/Region_segmentation/internal/support/satisfies.h>
#include <CGAL/Region_segmentation/internal/support/share.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

namespace internal {
template <typename RegionData>
using Has_area_and_perimeter = decltype(std::declval<const RegionData&>().perimeter /
                                        std::declval<const RegionData&>().area);
}

/// \ingroup PkgRegionSegmentationPolicies
/// The planarity \f$\rho = c^2 / (4 \pi s)\f$ of a region of perimeter \f$c\f$ and area \f$s\f$: 1
/// for a disc, more for any other plane shape, 0 for a region without neighbors, infinite where the
/// area is 0. It has no unit.
///
/// Source: \cgalCite{YZWLL14}, eq. 2.
template <typename RegionData>
double planarity(const RegionData& region)
{
  if (region.area == 0)
    return std::numeric_limits<double>::infinity();
  return region.perimeter * region.perimeter / (4 * CGAL_PI * region.area);
}

/// \ingroup PkgRegionSegmentationPolicies
/// Step two of the paper: merges a small region far from a disc next, across the section that
/// `Longest_flattest_section` chooses. A model of `MergingPolicy`.
///
/// The region \f$i\f$ that has a section and the largest sum over all other regions \f$j\f$ of
/// \f[ P_j(C_i) = 1 - \gamma \frac{e^{-\rho_i}}{e^{-\rho_i} + e^{-\rho_j}}
///              - (1 - \gamma) \frac{s_i}{s_i + s_j}, \f]
/// \f$s\f$ the area and \f$\rho\f$ the planarity; the lower id of equal sums. The cost of a merge
/// is 1 minus the mean of these terms: in [0, 1], low for an insignificant region.
///
/// Complexity: O(R^2) for R regions at the start, O(R) per merge, and the choice of the section.
///
/// Source: \cgalCite{YZWLL14}, eq. 4.
class Least_compact_region_first
{
public:
  /// `beta`: see `Longest_flattest_section`; `gamma`: the weight of planarity, in [0, 1]; that of
  /// the area is 1 - gamma
  explicit Least_compact_region_first(double beta = 0.1, double gamma = 0.6)
    : m_section_of(beta)
    , m_gamma(gamma)
  {}

  template <typename Graph>
  void initialize(const Graph& graph, std::size_t)
  {
    m_section_of.check_section_data<Graph>();
    static_assert(internal::satisfies<internal::Has_area_and_perimeter, typename Graph::RegionData>,
                  "Least_compact_region_first reads area and perimeter of RegionData, as "
                  "Region_geometry has them");
    m_regions.clear();
    m_slots.resize(graph.index_bound_of_regions());
    for (auto range = vertices(graph); range.first != range.second; ++range.first) {
      m_slots[*range.first] = std::uint32_t(m_regions.size());
      m_regions.push_back(*range.first);
    }
    const std::size_t n = m_regions.size();
    m_areas.resize(n);
    m_planarities.resize(n);
    m_compactness.resize(n);
    m_weights.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      set_shape(i, shape(graph, m_regions[i]));
    for (std::size_t i = 0; i < n; ++i)
      m_weights[i] = weight(i);
  }

  template <typename Graph>
  std::optional<Merge_candidate> next(const Graph& graph)
  {
    while (true) {
      const std::size_t best = slot_of_lowest_weight();
      if (best == m_regions.size() || m_weights[best] == settled)
        return std::nullopt;
      if (const auto section = m_section_of(graph, m_regions[best])) {
        const double others = double((std::max)(m_regions.size(), std::size_t(2)) - 1);
        return Merge_candidate{*section, (m_weights[best] - 0.5) / others};
      }
      m_weights[best] = settled; // it never gets a section, but still counts for the others
    }
  }

  template <typename Graph>
  void on_merge(const Graph& graph, const typename Graph::Merge& merge)
  {
    const std::size_t kept = m_slots[merge.kept];
    const Shape before = shape_in(kept), gone = shape_in(m_slots[merge.removed]);
    const Shape after = shape(graph, merge.kept);
    set_shape(kept, after);
    remove(m_slots[merge.removed]);
    for (std::size_t i = 0; i < m_regions.size(); ++i) {
      const Shape other = shape_in(i);
      m_weights[i] += term(other, after) - term(other, before) - term(other, gone);
    }
    m_weights[m_slots[merge.kept]] = weight(m_slots[merge.kept]);
  }

private:
  static constexpr double settled = std::numeric_limits<double>::infinity();

  struct Shape
  {
    double area, planarity;
    double compactness; // e^-planarity
  };

  template <typename Graph>
  static Shape shape(const Graph& graph, std::uint32_t region)
  {
    const double rho = planarity(graph[region]);
    return {graph[region].area, rho, std::exp(-rho)};
  }

  Shape shape_in(std::size_t slot) const
  {
    return {m_areas[slot], m_planarities[slot], m_compactness[slot]};
  }

  void set_shape(std::size_t slot, const Shape& shape)
  {
    m_areas[slot] = shape.area;
    m_planarities[slot] = shape.planarity;
    m_compactness[slot] = shape.compactness;
  }

  /// Moves the last slot here.
  void remove(std::size_t slot)
  {
    const std::uint32_t moved = m_regions.back();
    m_slots[moved] = std::uint32_t(slot);
    const auto move_last = [slot](auto& array) {
      array[slot] = array.back();
      array.pop_back();
    };
    move_last(m_regions);
    move_last(m_areas);
    move_last(m_planarities);
    move_last(m_compactness);
    move_last(m_weights);
  }

  /// The largest sum of P_j is the smallest sum of what it subtracts.
  std::size_t slot_of_lowest_weight() const
  {
    std::size_t best = m_regions.size();
    for (std::size_t i = 0; i < m_regions.size(); ++i)
      if (best == m_regions.size() || m_weights[i] < m_weights[best] ||
          (m_weights[i] == m_weights[best] && m_regions[i] < m_regions[best]))
        best = i;
    return best;
  }

  /// What P_j subtracts from 1.
  double term(const Shape& i, const Shape& j) const
  {
    return m_gamma * share_of_compactness(i, j) + (1 - m_gamma) * internal::share(i.area, j.area);
  }

  /// e^-a / (e^-a + e^-b), for planarities a and b up to infinity.
  static double share_of_compactness(const Shape& i, const Shape& j)
  {
    constexpr double least = 1e-290; // below it, e^-planarity has fewer digits, or is 0
    const double sum = i.compactness + j.compactness;
    if (sum > least)
      return i.compactness / sum;
    return i.planarity == j.planarity ? 0.5 : 1 / (1 + std::exp(i.planarity - j.planarity));
  }

  /// The sum over all regions j, itself included as 1/2.
  double weight(std::size_t slot) const
  {
    const Shape i = shape_in(slot);
    double sum = 0;
    for (std::size_t j = 0; j < m_regions.size(); ++j)
      sum += term(i, shape_in(j));
    return sum;
  }

  Longest_flattest_section m_section_of;
  double m_gamma;
  std::vector<std::uint32_t> m_slots;   // by region
  std::vector<std::uint32_t> m_regions; // by slot, and so the rest
  std::vector<double> m_areas, m_planarities, m_compactness, m_weights;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_LEAST_COMPACT_REGION_FIRST_H
