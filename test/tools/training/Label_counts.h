// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_LABEL_COUNTS_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_LABEL_COUNTS_H

#include <cstddef>
#include <utility>
#include <vector>

namespace train_merge_cost {

/// How many faces of each region have each label of each person, while regions are merged. With
/// them the Rand index distances between the regions and the segmentations by people are exact.
class Label_counts
{
public:
  Label_counts() = default;

  /// `region_of[f]` < `number_of_regions`; `people[i][f]`: the label of face f by person i, from 0
  /// on \pre there are at least two faces, and a person
  Label_counts(const std::vector<std::size_t>& region_of, std::size_t number_of_regions,
               const std::vector<std::vector<int>>& people);

  std::size_t number_of_people() const { return m_first_column.size() - 1; }

  /// The share of the pairs of faces, one in either region, that have one label; the mean over the
  /// people.
  double probability(std::size_t a, std::size_t b) const;

  /// The share of all pairs of faces that have one face in either region.
  double share_of_pairs(std::size_t a, std::size_t b) const
  {
    return m_faces[a] * m_faces[b] / m_pairs;
  }

  void merge(std::size_t kept, std::size_t removed);

  /// The Rand index distance between the regions and the segmentation by each person. O(regions *
  /// labels).
  std::vector<double> distances() const;

private:
  double* row(std::size_t region) { return m_counts.data() + region * m_first_column.back(); }
  const double* row(std::size_t region) const
  {
    return m_counts.data() + region * m_first_column.back();
  }

  std::vector<std::size_t> m_first_column; // of each person's labels, and the end
  std::vector<double> m_counts;            // by region, then by column
  std::vector<double> m_faces;             // by region
  double m_pairs = 0;
};

} // namespace train_merge_cost

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_LABEL_COUNTS_H
