// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXECUTION_H
#define CGAL_REGION_SEGMENTATION_EXECUTION_H

#include <CGAL/Region_segmentation/exceptions.h>

#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationData
/// How a stage runs: sequentially or in parallel, and which visitor follows its progress.
///
/// A part of a method that takes an `Execution` as its last argument reports its progress, so that a visitor can show
/// it and cancel the run. Reports come from the thread that called the stage.
///
/// \tparam ConcurrencyTag `Sequential_tag` or `Parallel_tag`
template <typename ConcurrencyTag = CGAL::Sequential_tag>
class Execution
{
public:
  using Concurrency_tag = ConcurrencyTag;
  static constexpr bool is_parallel = std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value;

  /// Without a visitor.
  Execution() = default;

  /// With a model of `SegmentationVisitor`, stored by reference; reports the start of the stage.
  /// \throws Segmentation_cancelled if the visitor cancels, here or later
  template <typename SegmentationVisitor>
  Execution(SegmentationVisitor& visitor, const char* stage)
    : m_visitor(&visitor), m_go_further(&call<SegmentationVisitor>), m_stage(stage)
  {
    report(0);
  }

  bool has_visitor() const { return m_go_further != nullptr; }

  /// Reports the fraction of the stage that is completed, in [0, 1].
  /// \throws Segmentation_cancelled if the visitor cancels
  void report(double fraction) const
  {
    if (has_visitor() && !m_go_further(m_visitor, m_stage, m_begin + fraction * m_share))
      throw Segmentation_cancelled();
  }

  /// The execution of a step of the stage: its progress in [0, 1] is mapped to [`begin`, `end`] of the stage.
  Execution step(double begin, double end) const
  {
    Execution result = *this;
    result.m_begin = m_begin + begin * m_share;
    result.m_share = (end - begin) * m_share;
    return result;
  }

private:
  template <typename Visitor>
  static bool call(const void* visitor, const char* stage, double fraction)
  {
    return const_cast<Visitor*>(static_cast<const Visitor*>(visitor))->go_further(stage, fraction);
  }

  const void* m_visitor = nullptr;
  bool (*m_go_further)(const void*, const char*, double) = nullptr;
  const char* m_stage = "";
  double m_begin = 0, m_share = 1;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_EXECUTION_H
