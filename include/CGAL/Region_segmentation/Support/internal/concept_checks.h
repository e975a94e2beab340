// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPPORT_INTERNAL_CONCEPT_CHECKS_H
#define CGAL_REGION_SEGMENTATION_SUPPORT_INTERNAL_CONCEPT_CHECKS_H

#include <CGAL/Region_segmentation/Support/exceptions.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

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

/// Checks the constants of the policies of `Policy_phases`.
template <typename... Policies>
void check_constants(const std::tuple<std::pair<Policies, std::size_t>...>& phases)
{
  std::apply([](const auto&... phase) { (check_constants(phase.first), ...); }, phases);
}

template <typename Map, typename Key>
using Has_key = std::enable_if_t<
  std::is_convertible<Key, typename boost::property_traits<Map>::key_type>::value>;

template <typename Map, typename FaceGraph>
constexpr bool check_face_map()
{
  static_assert(
    satisfies<Has_key, Map, typename boost::graph_traits<FaceGraph>::face_descriptor>,
    "a property map of the faces is needed: its key is the face descriptor of the mesh");
  return true;
}

template <typename Values>
using Number_of_parts = decltype(std::declval<const Values&>().number_of_parts());

/// A label in the type of another map. -1 stands for no segment in every integral type but `bool`,
/// and stays -1; every other label keeps its value.
/// \throws Invalid_input if the type `To` does not hold the label, and -1 beside it
template <typename To, typename Label>
To converted_label(Label label, const char* what = "label")
{
  static_assert(std::is_integral<To>::value,
                "labels are written to a map or range of an integral type, such as std::size_t");
  const auto is_none = [](auto l) {
    using Type = decltype(l);
    return !std::is_same<Type, bool>::value && l == Type(-1);
  };
  const To result = is_none(label) ? To(-1) : To(label);
  const bool has_value = Label(result) == label && (result > 0) == (label > 0);
  if (is_none(result) != is_none(label) || !(has_value || is_none(label)))
    throw Invalid_input(std::string(what) + " " + std::to_string(label) +
                        ": the type of the map does not hold it, and -1 for none beside it");
  return result;
}

/// \throws Invalid_input if the type `To` does not hold the labels below `n` beside -1, which
/// stands for none
template <typename To>
void check_labels(std::size_t n, const char* what = "label")
{
  if (n > 0)
    converted_label<To>(n - 1, what);
}

template <typename Map, typename FaceGraph>
constexpr bool check_edge_map()
{
  static_assert(
    satisfies<Has_key, Map, typename boost::graph_traits<FaceGraph>::edge_descriptor>,
    "a property map of the edges is needed: its key is the edge descriptor of the mesh. (One of a "
    "function f is boost::make_function_property_map<edge_descriptor>(f), one of a std::set s is "
    "CGAL::Boolean_property_map<decltype(s)>(s))");
  return true;
}

template <typename Kernel>
using Has_points_and_vectors = std::pair<typename Kernel::Point_3, typename Kernel::Vector_3>;

/// The kernel of the points of a map; `Simple_cartesian<double>` if they are not of a kernel.
template <typename PointMap>
using Kernel_of_points = std::conditional_t<
  satisfies<Has_points_and_vectors,
            typename Kernel_traits<typename boost::property_traits<PointMap>::value_type>::Kernel>,
  typename Kernel_traits<typename boost::property_traits<PointMap>::value_type>::Kernel,
  Simple_cartesian<double>>;

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPPORT_INTERNAL_CONCEPT_CHECKS_H
