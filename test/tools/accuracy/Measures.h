// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_MEASURES_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_MEASURES_H

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace princeton_benchmark {

/// The columns of every table of scores. All are dissimilarities.
enum Measure : std::size_t {
  RAND_INDEX, ///< 1 - Rand index
  CUT_DISCREPANCY,
  HAMMING,
  MISSING_RATE,
  FALSE_ALARM_RATE,
  GCE,
  LCE,
  GCE_AREA,
  LCE_AREA
};

constexpr std::size_t number_of_measures = 9;

constexpr std::array<const char*, number_of_measures> measure_names = {
  "1-RI", "CD", "Hamming", "missing", "false al.", "GCE", "LCE", "GCE area", "LCE area"};

constexpr std::array<const char*, number_of_measures> measure_columns = {"rand_index_distance",
                                                                         "cut_discrepancy",
                                                                         "hamming_distance",
                                                                         "missing_rate",
                                                                         "false_alarm_rate",
                                                                         "gce",
                                                                         "lce",
                                                                         "gce_area",
                                                                         "lce_area"};

/// The scores of a result against a truth, or a mean of such. One that is not defined, as the cut
/// discrepancy of a single segment, is NaN.
struct Measures
{
  std::array<double, number_of_measures> values{};

  double operator[](Measure m) const { return values[m]; }

  /// The scores with result and truth exchanged: only the two rates of the Hamming distance have
  /// a direction.
  Measures exchanged() const
  {
    Measures result = *this;
    result.values[MISSING_RATE] = values[FALSE_ALARM_RATE];
    result.values[FALSE_ALARM_RATE] = values[MISSING_RATE];
    return result;
  }
};

/// The mean of each measure over those of its values that are defined; NaN if there are none.
class Mean_measures
{
public:
  void add(const Measures& measures)
  {
    for (std::size_t m = 0; m < number_of_measures; ++m)
      if (!std::isnan(measures.values[m])) {
        m_sums[m] += measures.values[m];
        ++m_counts[m];
      }
  }

  Measures mean() const
  {
    Measures result;
    for (std::size_t m = 0; m < number_of_measures; ++m)
      result.values[m] = m_counts[m] > 0 ? m_sums[m] / double(m_counts[m])
                                         : std::numeric_limits<double>::quiet_NaN();
    return result;
  }

private:
  std::array<double, number_of_measures> m_sums{};
  std::array<std::size_t, number_of_measures> m_counts{};
};

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_MEASURES_H
