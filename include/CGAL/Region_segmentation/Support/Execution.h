// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPPORT_EXECUTION_H
#define CGAL_REGION_SEGMENTATION_SUPPORT_EXECUTION_H

#include <CGAL/Region_segmentation/Support/exceptions.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Support/parameters.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// What a library of threads does, as functions, so that no stage depends on that library.
struct Threads
{
  void (*for_each)(std::size_t first, std::size_t last, const std::function<void(std::size_t)>& f);
  std::size_t (*number)();
};

/// The functions for a concurrency tag; null for `Sequential_tag`.
template <typename ConcurrencyTag>
const Threads* threads_of()
{
  if constexpr (std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value) {
#ifdef CGAL_LINKED_WITH_TBB
    static const Threads threads = {
      [](std::size_t first, std::size_t last, const std::function<void(std::size_t)>& f) {
        tbb::parallel_for(first, last, f);
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

} // namespace internal

/// \ingroup PkgRegionSegmentationData
/// How a run is executed: sequentially or in parallel, and which visitor follows its progress and
/// may cancel it. Each stage receives it as a value. Reports come from the thread that called
/// `segment()`.
class Execution
{
public:
  /// An execution that is sequential and has no visitor.
  Execution() = default;
  /// An execution of a concurrency tag, without a visitor: of `CGAL::Sequential_tag` or, with TBB,
  /// of `CGAL::Parallel_tag`, as in `Execution execution{CGAL::Parallel_tag()}`.
  template <
    typename ConcurrencyTag,
    typename = std::enable_if_t<std::is_base_of<CGAL::Sequential_tag, ConcurrencyTag>::value>>
  explicit Execution(ConcurrencyTag)
    : m_threads(internal::threads_of<ConcurrencyTag>())
  {}

  /// The same execution with a model of `SegmentationVisitor`, which is stored by reference.
  template <typename SegmentationVisitor>
  Execution with_visitor(SegmentationVisitor& visitor) const
  {
    Execution result = *this;
    result.m_visitor = &visitor;
    result.m_on_progress = &call<SegmentationVisitor>;
    return result;
  }

  /// The same execution without its visitor.
  Execution silent() const
  {
    Execution result = *this;
    result.m_on_progress = nullptr;
    return result;
  }

  bool is_parallel() const { return m_threads != nullptr; }
  std::size_t number_of_threads() const { return m_threads ? m_threads->number() : 1; }

  /// The execution of a stage. The visitor learns that the stage begins.
  /// \throws Segmentation_cancelled if the visitor cancels, here or later
  Execution stage(const char* name) const
  {
    Execution result = *this;
    result.m_stage = name;
    result.m_begin = 0;
    result.m_share = 1;
    result.report(0);
    return result;
  }

  /// The execution of a step of a stage: its progress in [0, 1] is mapped to [`begin`, `end`] of
  /// the stage.
  Execution step(double begin, double end) const
  {
    Execution result = *this;
    result.m_begin = m_begin + begin * m_share;
    result.m_share = (end - begin) * m_share;
    return result;
  }

  /// Tells the visitor which fraction of the stage is completed, in [0, 1].
  /// \throws Segmentation_cancelled if the visitor cancels
  void report(double fraction) const
  {
    if (m_on_progress && !m_on_progress(m_visitor, m_stage, m_begin + fraction * m_share))
      throw Segmentation_cancelled();
  }

  /// Calls `f(i)` for i = `first` .. `last - 1`, in order or in parallel.
  void for_each(std::size_t first, std::size_t last,
                const std::function<void(std::size_t)>& f) const
  {
    if (m_threads && last - first > 1)
      m_threads->for_each(first, last, f);
    else
      for (std::size_t i = first; i < last; ++i)
        f(i);
  }

private:
  template <typename Visitor>
  static bool call(const void* visitor, const char* stage, double fraction)
  {
    return const_cast<Visitor*>(static_cast<const Visitor*>(visitor))->on_progress(stage, fraction);
  }

  const internal::Threads* m_threads = nullptr;
  const void* m_visitor = nullptr;
  bool (*m_on_progress)(const void*, const char*, double) = nullptr;
  const char* m_stage = "";
  double m_begin = 0, m_share = 1;
};

namespace internal {

// Work on all elements is divided into blocks of a fixed size, independent of the number of
// threads: the result of a block, and so every result, is the same sequentially and in parallel.
inline constexpr std::size_t block_size = 1 << 12;

/// The number of blocks that one thread labels as a range. Adjacencies between ranges are processed
/// sequentially, so ranges are long.
inline constexpr std::size_t blocks_in_range = 16;

inline std::size_t number_of_blocks(std::size_t number_of_elements, std::size_t size = block_size)
{
  return (number_of_elements + size - 1) / size;
}

/// Calls `f(block, begin, end)` for the blocks of elements 0 .. `number_of_elements - 1`, and
/// reports the progress.
inline void for_each_block(const Execution& execution, std::size_t number_of_elements,
                           const std::function<void(std::size_t, std::size_t, std::size_t)>& f,
                           std::size_t size = block_size)
{
  constexpr std::size_t number_of_reports = 50;
  const std::size_t number = number_of_blocks(number_of_elements, size);
  const std::size_t between_reports = (std::max)(number / number_of_reports + 1,
                                                 4 * execution.number_of_threads());
  for (std::size_t first = 0; first < number;) {
    const std::size_t last = (std::min)(first + between_reports, number);
    execution.for_each(first, last, [&](std::size_t block) {
      f(block, block * size, (std::min)((block + 1) * size, number_of_elements));
    });
    execution.report(double(last) / double(number));
    first = last;
  }
}

/// Fills one output by blocks of elements, each of which writes a contiguous part: calls
/// `write(block, begin, end, place)`, where the part of the block begins at `place`, and which
/// returns where this part ends. Returns where the output ends.
///
/// `number_in(block, begin, end)`: the size of the part of a block, which is asked for beforehand,
/// in parallel only
inline std::size_t for_each_block_of_output(
  const Execution& execution, std::size_t number_of_elements,
  const std::function<std::size_t(std::size_t, std::size_t, std::size_t)>& number_in,
  const std::function<std::size_t(std::size_t, std::size_t, std::size_t, std::size_t)>& write)
{
  std::vector<std::size_t> places(number_of_blocks(number_of_elements) + 1);
  if (execution.is_parallel())
    for_each_block(execution.step(0, 0.2), number_of_elements,
                   [&](std::size_t block, std::size_t begin, std::size_t end) {
                     places[block + 1] = number_in(block, begin, end);
                   });
  std::partial_sum(places.begin(), places.end(), places.begin());
  for_each_block(execution.step(execution.is_parallel() ? 0.2 : 0, 1), number_of_elements,
                 [&](std::size_t block, std::size_t begin, std::size_t end) {
                   const std::size_t past = write(block, begin, end, places[block]);
                   if (!execution.is_parallel())
                     places[block + 1] = past;
                 });
  return places.back();
}

/// Calls `f(i)` for i = 0 .. `n - 1`, block by block. The visitor learns nothing.
template <typename F>
void for_each_index(const Execution& execution, std::size_t n, const F& f)
{
  execution.for_each(0, number_of_blocks(n), [&](std::size_t block) {
    const std::size_t end = (std::min)((block + 1) * block_size, n);
    for (std::size_t i = block * block_size; i < end; ++i)
      f(i);
  });
}

/// Reports the progress of a known number of steps, at most two hundred times.
class Step_counter
{
public:
  Step_counter(const Execution& execution, std::size_t number_of_steps)
    : m_execution(execution)
    , m_number((std::max)(number_of_steps, std::size_t(1)))
  {}

  void advance()
  {
    if (++m_done < m_next_report)
      return;
    m_next_report = m_done + (std::max)(m_number / 100, std::size_t(1));
    m_execution.report((std::min)(1.0, double(m_done) / double(m_number)));
  }

private:
  Execution m_execution;
  std::size_t m_number, m_done = 0, m_next_report = 0;
};

template <typename T>
using Follows_progress = std::enable_if_t<
  std::is_convertible<decltype(std::declval<T&>().on_progress("", double())), bool>::value>;

/// The execution with the threads of a tag and the visitor of a pack, if it has one.
template <typename ConcurrencyTag, typename Pack>
Execution make_execution(const Pack& np)
{
  const Execution execution{ConcurrencyTag()};
  if constexpr (!has_parameter<Pack, CGAL::internal_np::visitor_t>)
    return execution;
  else {
    auto&& visitor = CGAL::parameters::get_parameter_reference(np, CGAL::internal_np::visitor);
    static_assert(
      satisfies<Follows_progress, std::remove_reference_t<decltype(visitor)>>,
      "a SegmentationVisitor needs: bool on_progress(const char* stage, double fraction)");
    static_assert(std::is_lvalue_reference<decltype(visitor)>::value,
                  "a SegmentationVisitor is not copied: pass it as visitor(std::ref(v))");
    return execution.with_visitor(visitor);
  }
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPPORT_EXECUTION_H
