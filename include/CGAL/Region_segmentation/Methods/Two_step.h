// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_TWO_STEP_H
#define CGAL_REGION_SEGMENTATION_METHODS_TWO_STEP_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Graph/geometry_data.h>
#include <CGAL/Region_segmentation/Hierarchy.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/grow_regions.h>
#include <CGAL/Region_segmentation/internal/segmenting/run_method.h>
#include <CGAL/Region_segmentation/internal/support/concept_checks.h>
#include <CGAL/Region_segmentation/requested_regions.h>

#include <CGAL/assertions.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// a / (a + b) for non-negative numbers, in [0, 1]; 1/2 where both are 0.
inline double share(double a, double b)
{
  return a + b == 0 ? 0.5 : a / (a + b);
}

} // namespace internal

/// \ingroup PkgRegionSegmentationPolicies
/// chooses, among the sections of a region, the one to merge across: long and flat compared with
/// the others.
///
/// The section \f$i\f$ has the largest sum over the region's other sections \f$j\f$ of
/// \f[ P_{ij} = \beta \frac{L_i}{L_i + L_j} + (1 - \beta) \frac{A_i}{A_i + A_j}, \f]
/// \f$L\f$ the length and \f$A\f$ the mean dihedral angle of a section; 0/0 is 1/2; the lower
/// neighbor id of equal sums. Sections that are not mergeable count only as \f$j\f$. Sections of
/// links alone count only if a region has no others.
///
/// Complexity: O(d p) for d sections, p of which are not exceeded by another one in both length and
/// angle: usually a few.
///
/// Source: \cgalCite{YZWLL14}, eq. 3.
class Longest_flattest_section
{
public:
  /// `beta`: the weight of the length, in [0, 1]; that of the angle is 1 - beta
  /// \throws Invalid_method if a constant is not in its range
  explicit Longest_flattest_section(double beta = 0.1)
    : m_beta(beta)
  {
    internal::check_constant("Longest_flattest_section: beta", beta, 0, 1);
  }

  /// The section, seen from the region; empty if the region has none that is mergeable.
  template <typename Graph>
  std::optional<Section_descriptor> operator()(const Graph& graph, std::uint32_t region)
  {
    m_sections.clear();
    const auto sections = graph.sections(region);
    const bool are_links = std::all_of(sections.begin(), sections.end(),
                                       [&](auto s) { return graph[s].has_links_alone(); });
    for (Section_descriptor s : sections)
      if (are_links || !graph[s].has_links_alone())
        m_sections.push_back(
          {s, graph.target(s), graph.is_mergeable(s), graph[s].length, graph[s].mean_angle()});

    const Section* best = nullptr;
    double best_sum = 0, longest = -1;
    // P_ij increases with angle and length, so the flattest section and those that are longer than
    // all flatter ones can have the largest sum, no others.
    while (const Section* s = flattest_above(longest)) {
      longest = s->length;
      const double sum = sum_over_others(*s);
      if (!best || sum > best_sum || (sum == best_sum && s->neighbor < best->neighbor)) {
        best = s;
        best_sum = sum;
      }
    }
    return best ? std::optional(best->descriptor) : std::nullopt;
  }

private:
  struct Section
  {
    Section_descriptor descriptor;
    std::uint32_t neighbor;
    bool is_mergeable;
    double length, angle;
  };

  /// Of the mergeable sections longer than `length`; of equal ones the longest, to the lowest
  /// neighbor. Null if there is none.
  const Section* flattest_above(double length) const
  {
    const Section* best = nullptr;
    for (const Section& s : m_sections)
      if (s.is_mergeable && s.length > length &&
          (!best || std::tie(s.angle, s.length, best->neighbor) >
                      std::tie(best->angle, best->length, s.neighbor)))
        best = &s;
    return best;
  }

  double sum_over_others(const Section& i) const
  {
    double sum = 0;
    for (const Section& j : m_sections)
      if (&j != &i)
        sum += m_beta * internal::share(i.length, j.length) +
               (1 - m_beta) * internal::share(i.angle, j.angle);
    return sum;
  }

  double m_beta;
  std::vector<Section> m_sections; // of the region
};

/// \ingroup PkgRegionSegmentationPolicies
/// Step one of the paper: merges the region of smallest area next (the lower id of equal ones;
/// never one whose area is NaN), across the section that `Longest_flattest_section` chooses. A
/// model of `MergingPolicy`; the cost is the area of the region, in squared units of
/// `Surface::unit()`.
///
/// Complexity: O(log R) per merge, and the choice of the section. A section is visited O(log A)
/// times, A the ratio of the largest to the smallest area, since a region that is smallest twice
/// has at least doubled.
///
/// Source: \cgalCite{YZWLL14}, section 3.3.
class Smallest_region_first
{
public:
  using RegionData = Region_geometry;
  using SectionData = Section_geometry;

  explicit Smallest_region_first(double beta = 0.1)
    : m_section_of(beta)
  {}

  template <typename Graph>
  void initialize(const Graph& graph)
  {
    m_queue = Queue();
    for (auto range = vertices(graph); range.first != range.second; ++range.first)
      push(graph, *range.first);
  }

  template <typename Graph>
  std::optional<Merge_candidate> next(const Graph& graph)
  {
    for (; !m_queue.empty(); m_queue.pop()) {
      const auto [area, region] = m_queue.top();
      if (graph.is_removed(region) || graph[region].area != area)
        continue;
      // A region without a section never gets one, so its entry is dropped.
      if (const auto section = m_section_of(graph, region))
        return Merge_candidate{*section, area};
    }
    return std::nullopt;
  }

  template <typename Graph>
  void on_merge(const Graph& graph, const typename Graph::Merge& merge)
  {
    push(graph, merge.kept);
  }

private:
  using Entry = std::pair<double, std::uint32_t>; // area, region: stale once the area has changed
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;

  template <typename Graph>
  void push(const Graph& graph, std::uint32_t region)
  {
    if (!std::isnan(graph[region].area))
      m_queue.push({graph[region].area, region});
  }

  Longest_flattest_section m_section_of;
  Queue m_queue;
};

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

/// \ingroup PkgRegionSegmentationMethods
/// The method of the paper: `Region_growing` between feature edges, merged by
/// `Smallest_region_first` while there are more than `factor` times the wanted number of regions,
/// then by `Least_compact_region_first`. A model of `SegmentationMethod`.
///
/// It requires the number of segments, on which the order of merges depends.
///
/// Source: \cgalCite{YZWLL14}.
struct Two_step
{
  Region_growing growing;
  double beta = 0.1;  ///< the weight of a section's length against its flatness, in [0, 1]
  double gamma = 0.6; ///< the weight of a region's planarity against its area, in [0, 1]
  double factor = 2;  ///< the number of regions after step one, as a multiple of the wanted number
                      ///< of segments, at least 1

  struct Prepared
  {
    Partition regions;
  };

  Prepared prepare(const Surface& surface, const Execution& execution = Execution()) const
  {
    growing.check_constants();
    internal::check_constant("Two_step: beta", beta, 0, 1);
    internal::check_constant("Two_step: gamma", gamma, 0, 1);
    internal::check_constant("Two_step: factor", factor, 1);
    return {growing(surface, execution.stage("regions"))};
  }

  Segmentation merge(const Surface& surface, const Prepared& prepared, const Request& request,
                     const Execution& execution = Execution()) const
  {
    const std::size_t number = request.number_of_segments;
    CGAL_precondition_msg(number >= 1, "Two_step needs the number of segments");
    Requested_regions requested = requested_regions(surface, prepared.regions, request.seeds);
    auto graph = internal::build_graph<Region_geometry, Section_geometry>(
      surface, requested.regions, execution.stage("graph"));
    const double after_step_one = (std::min)(factor * double(number),
                                             double(graph.number_of_regions()));
    const Policy_phases<Smallest_region_first, Least_compact_region_first> steps{
      {Smallest_region_first(beta), std::size_t(after_step_one)},
      {Least_compact_region_first(beta, gamma), number}};
    Merge_tree tree = merge_requested_regions(surface, requested, graph, steps, number,
                                              execution.stage("merging"));
    return {std::move(requested.regions), std::move(tree), number};
  }
};

#ifdef CGAL_REGION_SEGMENTATION_COMPILED
CGAL_REGION_SEGMENTATION_EXTERN template struct internal::Method_calls<Two_step>;
#endif

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_TWO_STEP_H
