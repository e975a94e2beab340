// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_EDGE_CONSTRAINTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_EDGE_CONSTRAINTS_H

#include <CGAL/Region_segmentation/internal/support/check_maps.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <type_traits>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The edges that the `edge_is_constrained_map` of a pack of named parameters constrains: none without that map.
template <typename FaceGraph, typename Pack>
class Edge_constraints
{
  using edge_descriptor = typename boost::graph_traits<FaceGraph>::edge_descriptor;
  using No_constraints = Static_boolean_property_map<edge_descriptor, false>;
  using Map = typename CGAL::internal_np::Lookup_named_param_def<CGAL::internal_np::edge_is_constrained_t, Pack,
                                                                 No_constraints>::type;
  static_assert(check_edge_map<Map, FaceGraph>());

public:
  static constexpr bool are_possible = !std::is_same<Map, No_constraints>::value;

  explicit Edge_constraints(const Pack& np)
    : m_map(CGAL::parameters::choose_parameter(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::edge_is_constrained), No_constraints()))
  {}

  bool operator()(const edge_descriptor& e) const { return bool(get(m_map, e)); }

private:
  Map m_map;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_EDGE_CONSTRAINTS_H
