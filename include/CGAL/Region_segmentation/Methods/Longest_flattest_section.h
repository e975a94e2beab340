// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_LONGEST_FLATTEST_SECTION_H
#define CGAL_REGION_SEGMENTATION_METHODS_LONGEST_FLATTEST_SECTION_H

#include <CGAL/Region_segmentation/Graph/Section_descriptor.h>
#include <CGAL/Region_segmentation/internal/support/check_constants.h>
#include <CGAL/Region_segmentation/internal/support/share.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

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

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_LONGEST_FLATTEST_SECTION_H
