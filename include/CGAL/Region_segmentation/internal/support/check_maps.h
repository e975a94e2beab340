// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_CHECK_MAPS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_CHECK_MAPS_H

#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/internal/support/satisfies.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

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

/// \throws Invalid_input if a type does not hold the labels below `n`, and -1 for none beside them
/// `what`: is written
template <typename Label>
void check_labels(std::size_t n, const char* what = "labels")
{
  static_assert(std::is_integral<Label>::value,
                "labels are written to a map or range of an integral type, such as std::size_t");
  constexpr auto greatest = (std::numeric_limits<Label>::max)();
  constexpr bool is_greatest_none = greatest == Label(-1) && !std::is_same<Label, bool>::value;
  constexpr std::size_t highest = std::size_t(greatest) - is_greatest_none;
  if (n > 0 && n - 1 > highest)
    throw Invalid_input(std::to_string(n) + " " + what +
                        ": the type of their map holds those from 0 to " + std::to_string(highest) +
                        ", and -1 for none");
}

/// \throws Invalid_input if a type does not hold a label that is not none, or takes it for none
template <typename To, typename Label>
void check_label(Label label)
{
  static_assert(std::is_integral<To>::value, "labels are written to a map of an integral type");
  if (Label(To(label)) != label || (To(label) == To(-1) && !std::is_same<To, bool>::value))
    throw Invalid_input("label " + std::to_string(label) +
                        ": the type of the map does not hold it, and -1 for none beside it");
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

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_CHECK_MAPS_H
