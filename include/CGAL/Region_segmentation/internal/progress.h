// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_PROGRESS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_PROGRESS_H

#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/internal/concept_checks.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

template <typename T>
using Goes_further = std::enable_if_t<
  std::is_convertible<decltype(std::declval<T&>().go_further("", double())), bool>::value>;

/// The visitor of a run that has none.
struct Silent_visitor
{
  bool go_further(const char*, double) const { return true; }
};

/// Tells the visitor of a pack about one stage, about a hundred times whatever the number of steps.
template <typename Pack>
class Progress
{
public:
  /// `stage`: its name; `steps`: how often `advance()` is expected.
  /// \throws Segmentation_cancelled if the visitor says so, here or later
  Progress(const Pack& np, const char* stage, std::size_t steps)
    : m_np(np), m_stage(stage), m_steps((std::max)(steps, std::size_t(1)))
  {
    report(0);
  }

  void advance()
  {
    if (++m_step < m_next_report)
      return;
    m_next_report = m_step + (std::max)(m_steps / 100, std::size_t(1));
    report((std::min)(1.0, double(m_step) / double(m_steps)));
  }

private:
  void report(double fraction) const
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter_reference;
    Silent_visitor silent;
    auto& visitor =
      choose_parameter(get_parameter_reference(m_np, CGAL::internal_np::visitor), silent);
    using Visitor = std::remove_reference_t<decltype(visitor)>;
    static_assert(satisfies<Goes_further, Visitor>,
                  "a SegmentationVisitor needs: bool go_further(const char* stage, double fraction)");
    if (!visitor.go_further(m_stage, fraction))
      throw Segmentation_cancelled();
  }

  const Pack& m_np;
  const char* m_stage;
  std::size_t m_steps, m_step = 0, m_next_report = 0;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_PROGRESS_H
