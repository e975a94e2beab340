// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LARGE_ARRAY_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LARGE_ARRAY_H

#include <boost/core/noinit_adaptor.hpp>

#include <cstddef>
#include <memory>
#include <new>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A vector with an element per face, edge or section. `resize()` does not initialize trivial
/// elements, so that memory is first touched by the thread that fills it.
template <typename T>
using Large_array = std::vector<T, boost::noinit_adaptor<std::allocator<T>>>;

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_LARGE_ARRAY_H
