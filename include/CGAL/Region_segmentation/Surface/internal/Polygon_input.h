// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_POLYGON_INPUT_H
#define CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_POLYGON_INPUT_H

#include <CGAL/Region_segmentation/Support/exceptions.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/internal/Face_graph_input.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A polygon soup as input of a segmentation. Values of polygons are read from, and labels written
/// to, a random access range or a property map by index.
class Polygon_input
{
public:
  /// The named parameter of constraints.
  static constexpr auto constraints = internal_np::constrained_edges;

  explicit Polygon_input(std::size_t number_of_polygons)
    : m_number(number_of_polygons)
  {}

  /// Constrains the edges between pairs of indices of points.
  template <typename PairRange, typename Pack>
  void add_constraints(Surface& surface, const PairRange& pairs, const Pack&) const
  {
    static_assert(satisfies<Pair_size, PairRange>,
                  "the constraints of polygons are a range of pairs of indices of points");
    std::vector<Vertex_pair> edges;
    for (const auto& [v, w] : pairs) {
      if (std::size_t(v) >= surface.number_of_vertices() ||
          std::size_t(w) >= surface.number_of_vertices())
        throw Invalid_input("a constraint has a point that does not exist");
      edges.push_back({Surface::Index(v), Surface::Index(w)});
    }
    constrain(surface, std::move(edges));
  }

  /// \throws Invalid_input if a range has another number of elements, or does not hold labels below
  /// `n`
  template <typename Map>
  void check(const Map& map, std::size_t n, const char* what = "label") const
  {
    static_assert(holds_labels<Map>(), "labels of polygons are a range or a property map of an "
                                       "integral type other than bool");
    check_size(map);
    if constexpr (is_range<Map>)
      check_labels<std::decay_t<decltype(map[0])>>(n, what);
    else
      check_labels<typename boost::property_traits<Map>::value_type>(n, what);
  }

  template <typename Map>
  auto values(const Map& map) const
  {
    check_size(map);
    using Value = std::decay_t<decltype(value(map, 0))>;
    std::vector<Value> result;
    result.reserve(m_number);
    for (std::size_t i = 0; i < m_number; ++i)
      result.push_back(value(map, i));
    return result;
  }

  template <typename Values, typename Map>
  void write(const Values& values, Map&& map) const
  {
    using Labels = std::decay_t<Map>;
    static_assert(std::is_lvalue_reference<Map>::value || !is_range<Labels>,
                  "a range for region_map is passed by std::ref()");
    check(map, values.number_of_parts());
    for (std::size_t i = 0; i < m_number; ++i)
      if constexpr (is_range<Labels>)
        map[i] = std::decay_t<decltype(map[i])>(values[i]);
      else
        put(map, i, typename boost::property_traits<Labels>::value_type(values[i]));
  }

private:
  template <typename Map>
  void check_size(const Map& map) const
  {
    if constexpr (is_range<Map>)
      if (const auto size = std::size_t(std::distance(std::begin(map), std::end(map)));
          size != m_number)
        throw Invalid_input("a range of " + std::to_string(size) + " elements for " +
                            std::to_string(m_number) + " polygons");
  }

  template <typename Map>
  static constexpr bool holds_labels()
  {
    if constexpr (is_range<Map>)
      return std::is_integral<std::decay_t<decltype(std::declval<Map&>()[0])>>::value;
    else
      return satisfies<Has_key, Map, std::size_t>;
  }

  /// Of a range of pairs. A property map of `bool` with iterators is not one.
  template <typename Range>
  using Pair_size = decltype(std::tuple_size<std::decay_t<decltype(*std::begin(
                               std::declval<const Range&>()))>>::value);

  template <typename Map>
  static auto value(const Map& map, std::size_t i)
  {
    if constexpr (is_range<Map>)
      return map[i];
    else
      return get(map, i);
  }

  std::size_t m_number;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_POLYGON_INPUT_H
