// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TWO_STEP_TWO_STEP_H
#define CGAL_REGION_SEGMENTATION_TWO_STEP_TWO_STEP_H

#include <CGAL/Region_segmentation/Graph/Hierarchy.h>
#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Graph/internal/run_method.h>
#include <CGAL/Region_segmentation/Graph/requested_regions.h>
#include <CGAL/Region_segmentation/Two_step/detect_feature_edges.h>
#include <CGAL/Region_segmentation/Two_step/grow_regions.h>

#include <CGAL/assertions.h>
#include <CGAL/number_type_config.h>

#include <boost/container/small_vector.hpp>

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
/// \f$L\f$ the length and \f$A\f$ the mean dihedral angle of a section (paper, eq. 3); 0/0 is 1/2;
/// the lower neighbor id of equal sums. Sections that are not mergeable count only as \f$j\f$.
/// Sections of links alone count only if a region has no others.
///
/// \param graph a `Region_adjacency_graph`
/// \param region the region
/// \param beta the weight of the length, in [0, 1]; that of the angle is 1 - beta
/// \returns the section, seen from the region; empty if the region has none that is mergeable
///
/// Complexity: O(d (p + log d)) for d sections, of which p are longer than all flatter ones:
/// usually a few.
template <typename Graph>
std::optional<Section_descriptor> longest_flattest_section(const Graph& graph, std::uint32_t region,
                                                           double beta)
{
  struct Section
  {
    Section_descriptor descriptor;
    double length, angle; // L, A
    std::uint32_t neighbor;
  };
  boost::container::small_vector<Section, 16> sections;
  const auto all = graph.sections(region);
  const bool are_links = std::all_of(all.begin(), all.end(),
                                     [&](auto s) { return graph[s].has_links_alone(); });
  for (const Section_descriptor s : all)
    if (are_links || !graph[s].has_links_alone())
      sections.push_back({s, graph[s].length, graph[s].mean_angle(), graph.target(s)});
  const auto sum_over_others = [&](const Section& i) {
    double sum = 0;
    for (const Section& j : sections)
      if (&j != &i)
        sum += beta * internal::share(i.length, j.length) +
               (1 - beta) * internal::share(i.angle, j.angle);
    return sum;
  };
  // P_ij grows with A_i and L_i, so a section that is not longer than a flatter one has no larger
  // sum. `next()` returns the flattest section that is longer than those before, of equally flat
  // ones the longest, of these the one to the lowest neighbor.
  double longest = -1;
  const auto next = [&] {
    const Section* s = nullptr;
    for (const Section& t : sections)
      if (t.length > longest && graph.is_mergeable(t.descriptor) &&
          (!s ||
           std::tie(t.angle, t.length, s->neighbor) > std::tie(s->angle, s->length, t.neighbor)))
        s = &t;
    return s;
  };
  const Section* best = nullptr;
  double best_sum = 0;
  while (const Section* s = next()) {
    longest = s->length;
    const double sum = sum_over_others(*s);
    if (!best || sum > best_sum || (sum == best_sum && s->neighbor < best->neighbor)) {
      best = s;
      best_sum = sum;
    }
  }
  return best ? std::optional(best->descriptor) : std::nullopt;
}

/// \ingroup PkgRegionSegmentationPolicies
/// Step one of the paper: merges the region of smallest area next (the lower id of equal ones;
/// never one whose area is NaN), across the section that
/// `longest_flattest_section()` chooses. A
/// model of `MergingPolicy`; the cost is the area of the region, in squared units of
/// `Surface::unit()`.
///
/// Complexity: O(log R) per merge, and the choice of the section.
class Smallest_region_first
{
public:
  using RegionData = Region_geometry;
  using SectionData = Section_geometry;

  /// `beta`: see `longest_flattest_section()`
  /// \throws Invalid_method if a constant is not in its range
  explicit Smallest_region_first(double beta = 0.1)
    : m_beta(beta)
  {
    internal::check_constant("Smallest_region_first: beta", beta, 0, 1);
  }

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
      if (!graph.is_removed(region) && graph[region].area == area)
        if (const auto section = longest_flattest_section(graph, region, m_beta))
          return Merge_candidate{*section, area}; // (a region without a section never gets one)
    }
    return std::nullopt;
  }

  template <typename Graph>
  void on_merge(const Graph& graph, const typename Graph::Merge& merge)
  {
    push(graph, merge.kept);
  }

private:
  using Entry = std::pair<double, std::uint32_t>; // area, region; outdated if the region has
                                                  // another area
  using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;

  template <typename Graph>
  void push(const Graph& graph, std::uint32_t region)
  {
    if (!std::isnan(graph[region].area))
      m_queue.push({graph[region].area, region});
  }

  double m_beta;
  Queue m_queue;
};

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
/// Step two of the paper: merges a small region far from a disc next, across the section that
/// `longest_flattest_section()` chooses. A model of `MergingPolicy`.
///
/// The region \f$i\f$ that has a section and the largest sum over all other regions \f$j\f$ of
/// \f[ P_j(C_i) = 1 - \gamma \frac{e^{-\rho_i}}{e^{-\rho_i} + e^{-\rho_j}}
///              - (1 - \gamma) \frac{s_i}{s_i + s_j}, \f]
/// \f$s\f$ the area and \f$\rho\f$ the planarity (paper, eq. 4); the lower id of equal sums. The
/// cost of a merge is 1 minus the mean of these terms: in [0, 1], low for an insignificant region.
///
/// Complexity: O(R^2) for R regions at the start, O(R) per merge, and the choice of the section.
class Least_compact_region_first
{
public:
  using RegionData = Region_geometry;
  using SectionData = Section_geometry;

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

  /// What P_j(C_i) subtracts from 1.
  double term(const Shape& i, const Shape& j) const
  {
    return m_gamma * share_of_compactness(i, j) + (1 - m_gamma) * internal::share(i.area, j.area);
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
  std::vector<double> m_sums;           // by region
};

/// \ingroup PkgRegionSegmentationMethods
/// The method of the paper: regions are grown between feature edges, then merged by
/// `Smallest_region_first` while there are more than `factor` times the wanted number of regions,
/// then by `Least_compact_region_first`. A model of `SegmentationMethod`.
///
/// It requires the number of segments, on which the order of merges depends.
///
/// Source: \cgalCite{YZWLL14}, section 3.
struct Two_step
{
  /// The deviation above which an edge is a feature edge, in degrees, in [0, 180].
  double maximum_angle = default_maximum_angle;
  /// Which edges can be feature edges.
  Feature_convexity feature_convexity = Feature_convexity::CONCAVE;
  double beta = 0.1;  ///< the weight of a section's length against its flatness, in [0, 1]
  double gamma = 0.6; ///< the weight of a region's planarity against its area, in [0, 1]
  double factor = 2;  ///< the number of regions after step one, as a multiple of the wanted number
                      ///< of segments, at least 1

  struct Prepared
  {
    Partition regions;
  };

  Prepared prepare(const Surface& surface, std::size_t /* number_of_segments */ = 0,
                   const Execution& execution = Execution()) const
  {
    internal::check_constant("Two_step: maximum_angle", maximum_angle, 0, 180);
    internal::check_constant("Two_step: beta", beta, 0, 1);
    internal::check_constant("Two_step: gamma", gamma, 0, 1);
    internal::check_constant("Two_step: factor", factor, 1);
    const Execution stage = execution.stage("regions");
    return {grow_regions(
      surface, mark_feature_edges(surface, maximum_angle, feature_convexity, stage.step(0, 0.5)),
      stage.step(0.5, 1))};
  }

  Segmentation merge(const Surface& surface, const Prepared& prepared, const Request& request,
                     const Execution& execution = Execution()) const
  {
    const std::size_t k = request.number_of_segments;
    CGAL_precondition_msg(k >= 1, "Two_step needs the number of segments");
    Requested_regions requested = requested_regions(surface, prepared.regions, request.seeds);
    auto graph = build_region_adjacency_graph(surface, requested.regions, execution.stage("graph"));
    const double after_step_one = (std::min)(factor * double(k), double(graph.number_of_regions()));
    Merge_tree tree = merge_requested_regions(
      surface, requested, graph,
      Policy_phases<Smallest_region_first, Least_compact_region_first>{
        {Smallest_region_first(beta), std::size_t(after_step_one)},
        {Least_compact_region_first(beta, gamma), k}},
      k, execution.stage("merging"));
    return {std::move(requested.regions), std::move(tree), k};
  }
};

#ifdef CGAL_REGION_SEGMENTATION_COMPILED
CGAL_REGION_SEGMENTATION_EXTERN template struct internal::Method_calls<Two_step>;
#endif

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_TWO_STEP_TWO_STEP_H
