// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_LONGEST_FLATTEST_SECTION_H
#define CGAL_REGION_SEGMENTATION_METHODS_LONGEST_FLATTEST_SECTION_H

#include <CGAL/Region_segmentation/Graph/Section_descriptor.h>
#include <CGAL/Region_segmentation/internal/support/satisfies.h>
#include <CGAL/Region_segmentation/internal/support/share.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

namespace internal {
template <typename SectionData>
using Has_length_and_angle = decltype(std::declval<const SectionData&>().length +
                                      std::declval<const SectionData&>().mean_angle() +
                                      std::declval<const SectionData&>().has_links_alone());
}

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
/// Complexity: O(d p) for d sections, p of which are not dominated by another one in both length
/// and angle: usually a few.
///
/// Source: \cgalCite{YZWLL14}, eq. 3.
class Longest_flattest_section
{
public:
  /// `beta`: the weight of the length, in [0, 1]; that of the angle is 1 - beta
  explicit Longest_flattest_section(double beta = 0.1)
    : m_beta(beta)
  {}

  /// Does not compile for a graph without the required data.
  template <typename Graph>
  static constexpr void check_section_data()
  {
    static_assert(internal::satisfies<internal::Has_length_and_angle, typename Graph::SectionData>,
                  "Longest_flattest_section reads length, mean_angle() and has_links_alone() of "
                  "SectionData, as Section_geometry has "
                  "them");
  }

  /// The section, seen from the region; empty if the region has none that is mergeable.
  template <typename Graph>
  std::optional<Section_descriptor> operator()(const Graph& graph, std::uint32_t region)
  {
    read_sections(graph, region);
    find_front(graph);
    if (m_front.empty())
      return std::nullopt;
    std::size_t best = m_front.front();
    double best_sum = 0;
    for (std::size_t i : m_front) {
      if (m_front.size() == 1)
        break;
      const double sum = sum_over_others(i);
      if (i == m_front.front() || sum > best_sum ||
          (sum == best_sum && graph.target(m_sections[i]) < graph.target(m_sections[best]))) {
        best = i;
        best_sum = sum;
      }
    }
    return m_sections[best];
  }

private:
  template <typename Graph>
  void read_sections(const Graph& graph, std::uint32_t region)
  {
    m_sections.clear();
    m_lengths.clear();
    m_angles.clear();
    bool are_links = true; // so far
    for (Section_descriptor s : graph.sections(region)) {
      const bool is_link = graph[s].has_links_alone();
      if (is_link && !are_links)
        continue;
      if (are_links && !is_link) {
        are_links = false;
        m_sections.clear();
        m_lengths.clear();
        m_angles.clear();
      }
      m_sections.push_back(s);
      m_lengths.push_back(graph[s].length);
      m_angles.push_back(graph[s].mean_angle());
    }
  }

  /// P_ij increases with length and with angle, so a section that is dominated in both by a
  /// mergeable one cannot win; of equal ones, that to the lower neighbor wins.
  template <typename Graph>
  void find_front(const Graph& graph)
  {
    m_front.clear();
    for (std::size_t i = 0; i < m_sections.size(); ++i) {
      if (!graph.is_mergeable(m_sections[i]))
        continue;
      const auto outdoes = [&](std::size_t a, std::size_t b) {
        return m_lengths[a] >= m_lengths[b] && m_angles[a] >= m_angles[b] &&
               (m_lengths[a] > m_lengths[b] || m_angles[a] > m_angles[b] ||
                graph.target(m_sections[a]) < graph.target(m_sections[b]));
      };
      bool is_outdone = false;
      auto kept = m_front.begin();
      for (auto j = m_front.begin(); j != m_front.end() && !is_outdone; ++j) {
        is_outdone = outdoes(*j, i);
        if (!outdoes(i, *j))
          *kept++ = *j;
      }
      if (is_outdone) // and outdoes none of the front
        continue;
      m_front.erase(kept, m_front.end());
      m_front.push_back(i);
    }
  }

  double sum_over_others(std::size_t i) const
  {
    double sum = 0;
    for (std::size_t j = 0; j < m_sections.size(); ++j)
      if (j != i)
        sum += m_beta * internal::share(m_lengths[i], m_lengths[j]) +
               (1 - m_beta) * internal::share(m_angles[i], m_angles[j]);
    return sum;
  }

  double m_beta;
  std::vector<Section_descriptor> m_sections; // of the region, and so the rest
  std::vector<double> m_lengths, m_angles;
  std::vector<std::size_t> m_front;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_LONGEST_FLATTEST_SECTION_H
