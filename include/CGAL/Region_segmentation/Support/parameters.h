// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPPORT_PARAMETERS_H
#define CGAL_REGION_SEGMENTATION_SUPPORT_PARAMETERS_H

/// \file parameters.h
/// The named parameters of the package: those of \cgal and its own, chained freely in one pack.
///
/// Only this file depends on the mechanism. A pack derives from `CGAL::Named_function_parameters`,
/// so \cgal's look-up functions read it, and every function of the package accepts packs made by
/// `CGAL::parameters`.

#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>

#include <CGAL/Named_function_parameters.h>

#include <functional>
#include <iterator>
#include <type_traits>
#include <utility>

// The parameters that the package adds: tag type, name. (And merge_tree, an output that is not a
// map.)
#define CGAL_REGION_SEGMENTATION_PARAMETERS(ADD)                                                   \
  ADD(number_of_segments_t, number_of_segments)                                                    \
  ADD(method_t, method)                                                                            \
  ADD(face_seed_map_t, face_seed_map)                                                              \
  ADD(component_links_t, component_links)                                                          \
  ADD(constrained_edges_t, constrained_edges)                                                      \
  ADD(region_map_t, region_map)                                                                    \
  ADD(clearance_t, clearance)                                                                      \
  ADD(tolerance_t, tolerance)

namespace CGAL {
namespace Region_segmentation {

class Merge_tree;

namespace internal_np {
#define CGAL_REGION_SEGMENTATION_ADD(TAG, NAME) enum TAG { NAME };
CGAL_REGION_SEGMENTATION_PARAMETERS(CGAL_REGION_SEGMENTATION_ADD)
#undef CGAL_REGION_SEGMENTATION_ADD
enum merge_tree_t { merge_tree };
} // namespace internal_np

template <typename T, typename Tag, typename Base = CGAL::internal_np::No_property>
struct Named_parameters;

namespace internal {

/// A pack with one value more.
template <typename Tag, typename T, typename... Base>
Named_parameters<T, Tag, Base...> with(const T& value, const Base&... others)
{
  return Named_parameters<T, Tag, Base...>(value, others...);
}

} // namespace internal

// CGAL's list of parameters has no include guard: it is included once for member functions and once
// for free functions, which CGAL_REGION_SEGMENTATION_FUNCTION defines. Later releases of CGAL use
// more macros than the first in their lists.
#define CGAL_add_named_parameter(TAG, ENUMERATOR, NAME)                                            \
  CGAL_REGION_SEGMENTATION_FUNCTION(CGAL::internal_np::TAG, NAME, const K&, value)
#define CGAL_add_named_parameter_with_compatibility(TAG, ENUMERATOR, NAME)                         \
  CGAL_REGION_SEGMENTATION_FUNCTION(CGAL::internal_np::TAG, NAME, const K&, value)
#define CGAL_add_named_parameter_with_compatibility_cref_only(TAG, ENUMERATOR, NAME)               \
  CGAL_REGION_SEGMENTATION_FUNCTION(CGAL::internal_np::TAG, NAME, const K&, std::cref(value))
#define CGAL_add_named_parameter_with_compatibility_ref_only(TAG, ENUMERATOR, NAME)                \
  CGAL_REGION_SEGMENTATION_FUNCTION(CGAL::internal_np::TAG, NAME, K&, std::ref(value))
#define CGAL_add_extra_named_parameter_with_compatibility(TAG, ENUMERATOR, NAME)
#define CGAL_REGION_SEGMENTATION_ADD(TAG, NAME)                                                    \
  CGAL_REGION_SEGMENTATION_FUNCTION(internal_np::TAG, NAME, const K&, value)

/// A pack of named parameters that can be chained with those of \cgal and those of this package.
template <typename T, typename Tag, typename Base>
struct Named_parameters : CGAL::Named_function_parameters<T, Tag, Base>
{
  using Pack = CGAL::Named_function_parameters<T, Tag, Base>;

  Named_parameters() = default;
  explicit Named_parameters(const T& value)
    : Pack(value)
  {}
  Named_parameters(const T& value, const Base& others)
    : Pack(value, others)
  {}

  const Pack& pack() const { return *this; }

#define CGAL_REGION_SEGMENTATION_FUNCTION(TAG, NAME, PARAMETER, VALUE)                             \
  template <typename K>                                                                            \
  auto NAME(PARAMETER value) const                                                                 \
  {                                                                                                \
    return internal::with<TAG>(VALUE, pack());                                                     \
  }
#include <CGAL/STL_Extension/internal/parameters_interface.h>
  CGAL_REGION_SEGMENTATION_PARAMETERS(CGAL_REGION_SEGMENTATION_ADD)
#undef CGAL_REGION_SEGMENTATION_FUNCTION

  auto merge_tree(std::reference_wrapper<Merge_tree> tree) const
  {
    return internal::with<internal_np::merge_tree_t>(tree, pack());
  }
};

namespace parameters {

using Default_named_parameters = Named_parameters<bool, CGAL::internal_np::all_default_t>;

/// An empty pack, which can also be chained.
inline Default_named_parameters default_values()
{
  return {};
}

#define CGAL_REGION_SEGMENTATION_FUNCTION(TAG, NAME, PARAMETER, VALUE)                             \
  template <typename K>                                                                            \
  auto NAME(PARAMETER value)                                                                       \
  {                                                                                                \
    return internal::with<TAG>(VALUE);                                                             \
  }
#include <CGAL/STL_Extension/internal/parameters_interface.h>
CGAL_REGION_SEGMENTATION_PARAMETERS(CGAL_REGION_SEGMENTATION_ADD)
#undef CGAL_REGION_SEGMENTATION_FUNCTION

inline auto merge_tree(std::reference_wrapper<Merge_tree> tree)
{
  return internal::with<internal_np::merge_tree_t>(tree);
}

} // namespace parameters

#undef CGAL_add_named_parameter
#undef CGAL_add_named_parameter_with_compatibility
#undef CGAL_add_named_parameter_with_compatibility_cref_only
#undef CGAL_add_named_parameter_with_compatibility_ref_only
#undef CGAL_add_extra_named_parameter_with_compatibility
#undef CGAL_REGION_SEGMENTATION_ADD

namespace internal {

/// The pack as \cgal's look-up functions deduce it: a chain has one such base for each of its
/// links; the outermost is used.
template <typename T, typename Tag, typename Base>
const CGAL::Named_function_parameters<T, Tag, Base>& pack(const Named_parameters<T, Tag, Base>& np)
{
  return np.pack();
}

template <typename T, typename Tag, typename Base>
const CGAL::Named_function_parameters<T, Tag, Base>&
pack(const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return np;
}

/// All other arguments do not compile, with this message alone.
template <typename T>
CGAL::Named_function_parameters<bool, CGAL::internal_np::all_default_t> pack(const T&)
{
  static_assert(
    !std::is_same<T, T>::value,
    "this argument is a pack of named parameters: pass a method by parameters::method()");
  return {};
}

/// Whether a pack has a parameter.
template <typename Pack, typename Tag>
constexpr bool has_parameter = !CGAL::parameters::is_default_parameter<Pack, Tag>::value;

template <typename T>
using Iterators_of_range = decltype(std::pair(std::begin(std::declval<const T&>()),
                                              std::end(std::declval<const T&>())));

template <typename T>
constexpr bool is_range = satisfies<Iterators_of_range, T>;

template <typename... Tags>
struct Tag_list
{};

/// The parameters with which a mesh is read.
using Reading_parameters = Tag_list<internal_np::component_links_t,
                                    CGAL::internal_np::edge_is_constrained_t,
                                    CGAL::internal_np::visitor_t>;

template <typename Tag, typename List>
struct Is_in;
template <typename Tag, typename... Tags>
struct Is_in<Tag, Tag_list<Tags...>> : std::disjunction<std::is_same<Tag, Tags>...>
{};

/// The parameters that no function ignores silently: those of the package, and those of \cgal that
/// functions of the package accept.
#define CGAL_REGION_SEGMENTATION_ADD(TAG, NAME) internal_np::TAG,
using Watched_parameters = Tag_list<
  CGAL_REGION_SEGMENTATION_PARAMETERS(CGAL_REGION_SEGMENTATION_ADD) internal_np::merge_tree_t,
  CGAL::internal_np::edge_is_constrained_t, CGAL::internal_np::visitor_t,
  CGAL::internal_np::maximum_angle_t, CGAL::internal_np::minimum_length_t>;
#undef CGAL_REGION_SEGMENTATION_ADD

template <typename Pack, typename Taken>
struct Takes_all : std::true_type
{};
template <typename T, typename Tag, typename Base, typename Taken>
struct Takes_all<CGAL::Named_function_parameters<T, Tag, Base>, Taken>
  : std::conjunction<
      std::disjunction<Is_in<Tag, Taken>, std::negation<Is_in<Tag, Watched_parameters>>>,
      Takes_all<Base, Taken>>
{};

/// Does not compile if a pack has one of the watched parameters that is not among the accepted
/// ones.
template <typename Pack, typename Taken>
constexpr void check_parameters()
{
  static_assert(Takes_all<Pack, Taken>::value, "one of the named parameters is not taken by this "
                                               "function (constants of a method are members of "
                                               "its parts)");
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#undef CGAL_REGION_SEGMENTATION_PARAMETERS

#endif // CGAL_REGION_SEGMENTATION_SUPPORT_PARAMETERS_H
