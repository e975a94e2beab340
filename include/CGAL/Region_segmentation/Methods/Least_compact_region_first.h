// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_LEAST_COMPACT_REGION_FIRST_H
#define CGAL_REGION_SEGMENTATION_METHODS_LEAST_COMPACT_REGION_FIRST_H

#include <CGAL/Region_segmentation/Methods/Longest_flattest_section.h>
#include <CGAL/Region_segmentation/Graph/Merge_candidate.h>
#include <CGAL/Region_segmentation/Graph/geometry_data.h>
#include <CGAL/Region_segmentation/internal/support/check_constants.h>
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

/// \ingroup PkgRegionSegmentationPolicies
/// The planarity \f$\rho = c^2 / (4 \pi s)\f$ of a region of perimeter \f$c\f$ and area \f$s\f$: 1
/// for a disc, more for any other plane shape, 0 for a region without neighbors, infinite where the
/// area is 0. It has no unit.
///
/// Source: \cgalCite{YZWLL14}, eq. 2.
inline double planarity(const Region_geometry& region)
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
  using RegionData = Region_geometry;
  using SectionData = Section_geometry;

  /// `beta`: see `Longest_flattest_section`; `gamma`: the weight of planarity, in [0, 1]; that of
  /// the area is 1 - gamma
  /// \throws Invalid_method if a constant is not in its range
  explicit Least_compact_region_first(double beta = 0.1, double gamma = 0.6)
    : m_section_of(beta)
    , m_gamma(gamma)
  {
    internal::check_constant("Least_compact_region_first: gamma", gamma, 0, 1);
  }

  template <typename Graph>
  void initialize(const Graph& graph)
  {
    m_entries.clear();
    m_slots.resize(graph.index_bound_of_regions());
    for (auto range = vertices(graph); range.first != range.second; ++range.first) {
      m_slots[*range.first] = m_entries.size();
      m_entries.push_back({*range.first, shape(graph, *range.first), 0});
    }
    for (Entry& entry : m_entries)
      entry.weight = weight(entry.shape);
  }

  template <typename Graph>
  std::optional<Merge_candidate> next(const Graph& graph)
  {
    while (!m_entries.empty()) {
      // The largest sum of P_j is the smallest sum of what it subtracts.
      const auto best = std::min_element(
        m_entries.begin(), m_entries.end(), [](const Entry& a, const Entry& b) {
          return a.weight != b.weight ? a.weight < b.weight : a.region < b.region;
        });
      if (best->weight == settled)
        break;
      if (const auto section = m_section_of(graph, best->region)) {
        const double others = double((std::max)(m_entries.size(), std::size_t(2)) - 1);
        return Merge_candidate{*section, (best->weight - 0.5) / others};
      }
      best->weight = settled; // it never gets a section, but still counts for the others
    }
    return std::nullopt;
  }

  template <typename Graph>
  void on_merge(const Graph& graph, const typename Graph::Merge& merge)
  {
    const Shape before = m_entries[m_slots[merge.kept]].shape,
                gone = m_entries[m_slots[merge.removed]].shape, after = shape(graph, merge.kept);
    m_entries[m_slots[merge.kept]].shape = after;
    remove(merge.removed);
    for (Entry& entry : m_entries)
      entry.weight += term(entry.shape, after) - term(entry.shape, before) -
                      term(entry.shape, gone);
    m_entries[m_slots[merge.kept]].weight = weight(after);
  }

private:
  static constexpr double settled = std::numeric_limits<double>::infinity();

  struct Shape
  {
    double area, planarity;
    double compactness; // e^-planarity
  };

  struct Entry
  {
    std::uint32_t region;
    Shape shape;
    double weight; // the sum of what P_j subtracts from 1
  };

  template <typename Graph>
  static Shape shape(const Graph& graph, std::uint32_t region)
  {
    const double rho = planarity(graph[region]);
    return {graph[region].area, rho, std::exp(-rho)};
  }

  /// Moves the last entry to its place.
  void remove(std::uint32_t region)
  {
    m_slots[m_entries.back().region] = m_slots[region];
    m_entries[m_slots[region]] = m_entries.back();
    m_entries.pop_back();
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
  double weight(const Shape& i) const
  {
    double sum = 0;
    for (const Entry& j : m_entries)
      sum += term(i, j.shape);
    return sum;
  }

  Longest_flattest_section m_section_of;
  double m_gamma;
  std::vector<Entry> m_entries;     // of the remaining regions
  std::vector<std::size_t> m_slots; // by region: the place of its entry
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_LEAST_COMPACT_REGION_FIRST_H
