// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_BENCHMARK_OPTIONS_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_BENCHMARK_OPTIONS_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace princeton_benchmark {

struct Benchmark_options
{
  std::string data_folder; ///< empty: the procedural models
  /// Given: `learned`, `visibility` and `two-step` on variants of the procedural models instead,
  /// random with it.
  std::optional<std::uint32_t> variants_seed;
  std::string method = "learned";
  std::size_t number_of_threads = 1, number_of_runs = 1;
  std::string csv_file, report_file; ///< empty: none
};

/// The options, or the exit status where the program has nothing left to do: help was shown (0), or
/// the command line makes no sense (2).
std::variant<Benchmark_options, int> parse_command_line(int argc, char** argv);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_BENCHMARK_OPTIONS_H
