// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_MEASUREMENT_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_MEASUREMENT_H

#include "Stage_clock.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace speed_benchmark {

/// The median; of an even number, the mean of the two in the middle.
/// \pre there are values
double median(std::vector<double> values);

/// Medians over rounds. Ratios are taken in each round: what disturbs a round disturbs both.
struct Measurement
{
  std::size_t rounds = 0, number_of_regions = 0, peak_bytes = 0;
  bool has_stages = false;
  std::array<double, number_of_stages> seconds_of_stage = {};
  double seconds = 0, floor_seconds = 0;
  double regions_by_floor = 0; ///< all before merging, by the floor
  double whole_by_floor = 0;
  std::optional<double> by_reference;
  std::optional<double> gain_of_floor; ///< one thread by several
};

/// What is run in turns.
struct Contest
{
  std::function<double()> floor;      ///< seconds
  std::function<double()> slow_floor; ///< on one thread, where the floor is on several; may be
                                      ///< empty
  std::function<Stage_seconds()> subject;
  std::function<double()> reference;     ///< seconds; may be empty
  Stage compared_until = Stage::BORDERS; ///< the part of the subject that is compared with the
                                         ///< reference
};

/// Runs each once without timing, the subject with its memory counted; then in turns, at least
/// three rounds, until `seconds_wanted` are over.
Measurement measure(const Contest& contest, double seconds_wanted);

} // namespace speed_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_MEASUREMENT_H
