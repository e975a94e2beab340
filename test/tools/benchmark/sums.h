// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_SUMS_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_SUMS_H

#include <cstddef>
#include <vector>

namespace speed_benchmark {

/// The floor of runs on several threads: as many bytes as the flat mesh of a closed triangle mesh
/// has, read once.
class Sums
{
public:
  explicit Sums(std::size_t number_of_faces)
    : m_numbers(7 * number_of_faces, 1.0)
  {}

  double on_one_thread() const;
  /// On as many threads as TBB may use.
  double in_parallel() const;

private:
  std::vector<double> m_numbers; // 56 bytes a face
};

} // namespace speed_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_SUMS_H
