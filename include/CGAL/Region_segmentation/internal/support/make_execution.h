// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_MAKE_EXECUTION_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_MAKE_EXECUTION_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/support/satisfies.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The threads of a concurrency tag; null for `Sequential_tag`.
template <typename ConcurrencyTag>
const Threads* threads_of()
{
  if constexpr (std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value) {
#ifdef CGAL_LINKED_WITH_TBB
    static const Threads threads = {
      [](std::size_t first, std::size_t last, Function_ref<void(std::size_t)> f) {
        tbb::parallel_for(first, last, [=](std::size_t i) { f(i); });
      },
      [] { return std::size_t(tbb::this_task_arena::max_concurrency()); }};
    return &threads;
#else
    static_assert(!std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value,
                  "Parallel_tag needs TBB: link CGAL::TBB_support");
#endif
  }
  return nullptr;
}

template <typename T>
using Goes_further = std::enable_if_t<
  std::is_convertible<decltype(std::declval<T&>().go_further("", double())), bool>::value>;

/// The execution with the threads of a tag and the visitor of a pack, if it has one.
template <typename ConcurrencyTag, typename Pack>
Execution make_execution(const Pack& np)
{
  const Execution execution(threads_of<ConcurrencyTag>());
  if constexpr (!has_parameter<Pack, CGAL::internal_np::visitor_t>)
    return execution;
  else {
    auto&& visitor = CGAL::parameters::get_parameter_reference(np, CGAL::internal_np::visitor);
    static_assert(
      satisfies<Goes_further, std::remove_reference_t<decltype(visitor)>>,
      "a SegmentationVisitor needs: bool go_further(const char* stage, double fraction)");
    static_assert(std::is_lvalue_reference<decltype(visitor)>::value,
                  "a SegmentationVisitor is not copied: pass it as visitor(std::ref(v))");
    return execution.with_visitor(visitor);
  }
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_MAKE_EXECUTION_H
