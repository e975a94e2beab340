// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TWO_STEP_LONGEST_FLATTEST_SECTION_H
#define CGAL_REGION_SEGMENTATION_TWO_STEP_LONGEST_FLATTEST_SECTION_H

#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// a / (a + b) for non-negative numbers, in [0, 1]; 1/2 where both are 0.
inline double share(double a, double b)
{
  return a + b == 0 ? 0.5 : a / (a + b);
}

/// Rounds a term of eq. 3 or eq. 4 to a multiple of 2^-36, the last digit of a double from 2^16 on.
/// Sums of up to 2^17 such terms are exact and do not depend on the order of the terms, so values
/// that are equal but for rounding have equal sums. (With `std::floor()` in place of the addition,
/// `Two_step` takes 1.4 times as long for 1000 segments of a mesh of 20,000 faces.)
inline double rounded_term(double term)
{
  constexpr double two_to_16 = 65536;
  return (term + two_to_16) - two_to_16;
}

/// A section of a region, with what eq. 3 of the paper compares.
struct Compared_section
{
  Section_descriptor descriptor;
  std::uint32_t neighbor;
  double length, angle; // L, A
};
using Compared_sections = boost::container::small_vector<Compared_section, 16>;

/// Returns the sections of a region that eq. 3 compares: all of them if links alone can be merged
/// across, else those that are not of links alone.
template <typename Graph>
Compared_sections compared_sections(const Graph& graph, std::uint32_t region)
{
  const auto all = graph.sections(region);
  const bool has_edges_to_merge = std::any_of(all.begin(), all.end(), [&](auto s) {
    return graph.is_mergeable(s) && !graph[s].has_links_alone();
  });
  Compared_sections result;
  for (const Section_descriptor s : all)
    if (!has_edges_to_merge || !graph[s].has_links_alone())
      result.push_back({s, graph.target(s), graph[s].length, graph[s].mean_angle()});
  return result;
}

/// Eq. 3 of the paper: returns the sum of P_ij over the other sections j,
/// P_ij = beta L_i / (L_i + L_j) + (1 - beta) A_i / (A_i + A_j).
inline double sum_of_eq_3(const Compared_section& i, const Compared_sections& sections, double beta)
{
  double sum = 0;
  for (const Compared_section& j : sections)
    if (&j != &i)
      sum += rounded_term(beta * share(i.length, j.length) + (1 - beta) * share(i.angle, j.angle));
  return sum;
}

} // namespace internal

/// \ingroup PkgRegionSegmentationPolicies
/// chooses, among the sections of a region, the one to merge across: long and flat compared with
/// the others.
///
/// The section \f$i\f$ has the largest sum over the region's other sections \f$j\f$ of
/// \f[ P_{ij} = \beta \frac{L_i}{L_i + L_j} + (1 - \beta) \frac{A_i}{A_i + A_j}, \f]
/// \f$L\f$ the length and \f$A\f$ the mean dihedral angle of a section (paper, eq. 3); 0/0 is 1/2;
/// the lower neighbor id of equal sums. Each \f$P_{ij}\f$ is rounded to a multiple of
/// \f$2^{-36}\f$, so that rounding does not decide between equal sections. Sections that are not
/// mergeable count only as \f$j\f$. Sections of links alone count only if the region has no other
/// section that is mergeable.
///
/// \param graph a `Region_adjacency_graph`
/// \param region the region
/// \param beta the weight of the length, in [0, 1]; that of the angle is 1 - beta
/// \returns the section, seen from the region; empty if the region has none that is mergeable
///
/// Complexity: O(d^2) for d sections.
template <typename Graph>
std::optional<Section_descriptor> longest_flattest_section(const Graph& graph, std::uint32_t region,
                                                           double beta)
{
  const internal::Compared_sections sections = internal::compared_sections(graph, region);
  const internal::Compared_section* best = nullptr;
  double best_sum = 0;
  for (const internal::Compared_section& i : sections) {
    if (!graph.is_mergeable(i.descriptor))
      continue;
    const double sum = internal::sum_of_eq_3(i, sections, beta);
    if (!best || sum > best_sum || (sum == best_sum && i.neighbor < best->neighbor)) {
      best = &i;
      best_sum = sum;
    }
  }
  return best ? std::optional(best->descriptor) : std::nullopt;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_TWO_STEP_LONGEST_FLATTEST_SECTION_H
