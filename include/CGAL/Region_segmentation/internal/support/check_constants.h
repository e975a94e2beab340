// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_CHECK_CONSTANTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_CHECK_CONSTANTS_H

#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/internal/support/satisfies.h>

#include <cstddef>
#include <limits>
#include <sstream>
#include <tuple>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

constexpr double least_positive = (std::numeric_limits<double>::min)(),
                 greatest_finite = (std::numeric_limits<double>::max)();

/// \throws Invalid_method if a constant is not in its range, as NaN is in none
inline void check_constant(const char* name, double value, double least,
                           double greatest = greatest_finite)
{
  if (value >= least && value <= greatest)
    return;
  std::ostringstream message;
  message << name << " is " << value << ", which is not in [" << least << ", " << greatest << ']';
  throw Invalid_method(message.str());
}

template <typename Part>
using Has_constants = decltype(std::declval<const Part&>().check_constants());

/// Checks the constants of a part of a method, if it has a function for that.
template <typename Part>
void check_constants(const Part& part)
{
  if constexpr (satisfies<Has_constants, Part>)
    part.check_constants();
}

/// Those of `Policy_phases`.
template <typename... Policies>
void check_constants(const std::tuple<std::pair<Policies, std::size_t>...>& phases)
{
  std::apply([](const auto&... phase) { (check_constants(phase.first), ...); }, phases);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_CHECK_CONSTANTS_H
