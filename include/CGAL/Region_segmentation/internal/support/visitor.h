// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_VISITOR_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_VISITOR_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/support/satisfies.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

template <typename T>
using Goes_further = std::enable_if_t<
  std::is_convertible<decltype(std::declval<T&>().go_further("", double())), bool>::value>;

/// The execution of a stage, with the visitor of a pack, if it has one; the pack must outlive it.
/// \throws Segmentation_cancelled if the visitor cancels
template <typename ConcurrencyTag, typename Pack>
Execution<ConcurrencyTag> make_execution(const Pack& np, const char* stage)
{
  if constexpr (CGAL::parameters::is_default_parameter<Pack, CGAL::internal_np::visitor_t>::value)
    return Execution<ConcurrencyTag>();
  else {
    auto&& visitor = CGAL::parameters::get_parameter_reference(np, CGAL::internal_np::visitor);
    static_assert(satisfies<Goes_further, std::remove_reference_t<decltype(visitor)>>,
                  "a SegmentationVisitor needs: bool go_further(const char* stage, double fraction)");
    static_assert(std::is_lvalue_reference<decltype(visitor)>::value,
                  "a SegmentationVisitor is not copied: pass it as visitor(std::ref(v))");
    return Execution<ConcurrencyTag>(visitor, stage);
  }
}

/// Reports steps of a stage whose number is known, about a hundred times in all.
template <typename ConcurrencyTag>
class Step_counter
{
public:
  Step_counter(const Execution<ConcurrencyTag>& execution, std::size_t number_of_steps)
    : m_execution(execution), m_number((std::max)(number_of_steps, std::size_t(1)))
  {}

  void advance()
  {
    if (++m_done < m_next_report)
      return;
    m_next_report = m_done + (std::max)(m_number / 100, std::size_t(1));
    m_execution.report((std::min)(1.0, double(m_done) / double(m_number)));
  }

private:
  Execution<ConcurrencyTag> m_execution;
  std::size_t m_number, m_done = 0, m_next_report = 0;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_VISITOR_H
