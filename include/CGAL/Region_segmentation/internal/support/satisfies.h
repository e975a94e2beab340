// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_SATISFIES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_SATISFIES_H

#include <type_traits>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

template <typename, template <typename...> class Requirement, typename... Types>
struct Satisfies : std::false_type
{};

template <template <typename...> class Requirement, typename... Types>
struct Satisfies<std::void_t<Requirement<Types...>>, Requirement, Types...> : std::true_type
{};

/// Whether the alias `Requirement<Types...>` is well-formed: each requirement of a concept is such
/// an alias.
template <template <typename...> class Requirement, typename... Types>
constexpr bool satisfies = Satisfies<void, Requirement, Types...>::value;

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_SATISFIES_H
