// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TWO_STEP_LONGEST_FLATTEST_SECTION_H
#define CGAL_REGION_SEGMENTATION_TWO_STEP_LONGEST_FLATTEST_SECTION_H

#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// a / (a + b) for non-negative numbers, in [0, 1]; 1/2 where both are 0.
inline double share(double a, double b)
{
  return a + b == 0 ? 0.5 : a / (a + b);
}

/// A section of a region, with what eq. 3 of the paper compares.
struct Compared_section
{
  Section_descriptor descriptor;
  std::uint32_t neighbor;
  double length, angle; // L and A; 0 if the weight of the length, or of the angle, is 0
  bool is_mergeable;
};
using Compared_sections = boost::container::small_vector<Compared_section, 16>;

/// Returns the sections of a region that eq. 3 compares. Sections that consist of links alone are
/// among them only if the region has no other section that can be merged across.
template <typename Graph>
Compared_sections compared_sections(const Graph& graph, std::uint32_t region, double beta)
{
  const auto all = graph.sections(region);
  const bool has_edges_to_merge = std::any_of(all.begin(), all.end(), [&](auto s) {
    return graph.is_mergeable(s) && !graph[s].has_links_alone();
  });
  Compared_sections result;
  for (const Section_descriptor s : all)
    if (!has_edges_to_merge || !graph[s].has_links_alone())
      result.push_back({s, graph.target(s), beta > 0 ? graph[s].length : 0,
                        beta < 1 ? graph[s].mean_angle() : 0, graph.is_mergeable(s)});
  return result;
}

/// Returns the flattest of the mergeable sections that are longer than `longest`; ties: the longest
/// one, then the lowest neighbor. Null if there is none.
///
/// The sum of eq. 3 grows with the length and the angle of a section, so only a section that is
/// longer than all flatter ones can have the largest sum. Usually these are few: with the sums of
/// all sections, `Two_step` took 1.9 times as long for 1000 segments of a noisy mesh of 1 million
/// faces.
inline const Compared_section* flattest_longer_than(const Compared_sections& sections,
                                                    double longest)
{
  const Compared_section* result = nullptr;
  for (const Compared_section& s : sections)
    if (s.is_mergeable && s.length > longest &&
        (!result || std::tie(s.angle, s.length, result->neighbor) >
                      std::tie(result->angle, result->length, s.neighbor)))
      result = &s;
  return result;
}

/// Eq. 3 of the paper: returns the sum of P_ij over the other sections j,
/// P_ij = beta L_i / (L_i + L_j) + (1 - beta) A_i / (A_i + A_j).
inline double sum_of_eq_3(const Compared_section& i, const Compared_sections& sections, double beta)
{
  double sum = 0;
  for (const Compared_section& j : sections)
    if (j.descriptor != i.descriptor)
      sum += beta * share(i.length, j.length) + (1 - beta) * share(i.angle, j.angle);
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
/// the lower neighbor id of equal sums, and of sections of equal length and angle. Sections that
/// are not mergeable count only as \f$j\f$. Sections of links alone count only if the region has no
/// other section that is mergeable.
///
/// \param graph a `Region_adjacency_graph`
/// \param region the region
/// \param beta the weight of the length, in [0, 1]; that of the angle is 1 - beta
/// \returns the section, seen from the region; empty if the region has none that is mergeable
///
/// Complexity: O(p d) for d sections, of which p are longer than all flatter ones: usually a few.
template <typename Graph>
std::optional<Section_descriptor> longest_flattest_section(const Graph& graph, std::uint32_t region,
                                                           double beta)
{
  const auto sections = internal::compared_sections(graph, region, beta);
  const internal::Compared_section* best = nullptr;
  double best_sum = 0, longest = -1;
  while (const internal::Compared_section* i = internal::flattest_longer_than(sections, longest)) {
    longest = i->length;
    const double sum = internal::sum_of_eq_3(*i, sections, beta);
    if (!best || sum > best_sum || (sum == best_sum && i->neighbor < best->neighbor)) {
      best = i;
      best_sum = sum;
    }
  }
  return best ? std::optional(best->descriptor) : std::nullopt;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_TWO_STEP_LONGEST_FLATTEST_SECTION_H
