// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_SPEED_ALLOCATED_BYTES_H
#define CGAL_REGION_SEGMENTATION_TEST_SPEED_ALLOCATED_BYTES_H

#include <cstddef>
#include <functional>

namespace speed_benchmark {

/// The most bytes that a call holds at any time beyond what was there before, counted in `operator
/// new` and `delete` of this program (as the blocks are, rounded up by malloc): the same number in
/// every run, whatever the system does with pages.
std::size_t peak_of_allocated_bytes(const std::function<void()>& function);

} // namespace speed_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_SPEED_ALLOCATED_BYTES_H
