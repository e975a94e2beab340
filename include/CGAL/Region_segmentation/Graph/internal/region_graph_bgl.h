// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_REGION_GRAPH_BGL_H
#define CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_REGION_GRAPH_BGL_H

#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>

#include <boost/graph/properties.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

// The free functions that make a region adjacency graph a model of Boost.Graph's concepts, found by
// argument-dependent look-up. num_vertices() and num_edges() are upper bounds of the indices.

namespace CGAL {
namespace Region_segmentation {

template <typename R, typename S>
std::size_t num_vertices(const Region_adjacency_graph<R, S>& g)
{
  return g.index_bound_of_regions();
}

template <typename R, typename S>
std::size_t num_edges(const Region_adjacency_graph<R, S>& g)
{
  return g.index_bound_of_sections();
}

template <typename R, typename S>
auto vertices(const Region_adjacency_graph<R, S>& g)
{
  return internal::remaining<typename Region_adjacency_graph<R, S>::vertex_iterator>(
    g, internal::Number_iterator(0), internal::Number_iterator(std::uint32_t(num_vertices(g))));
}

template <typename R, typename S>
auto edges(const Region_adjacency_graph<R, S>& g)
{
  return internal::remaining<typename Region_adjacency_graph<R, S>::edge_iterator>(
    g, internal::Number_iterator(0), internal::Number_iterator(std::uint32_t(num_edges(g))));
}

template <typename R, typename S>
std::uint32_t source(Section_descriptor s, const Region_adjacency_graph<R, S>& g)
{
  return g.source(s);
}

template <typename R, typename S>
std::uint32_t target(Section_descriptor s, const Region_adjacency_graph<R, S>& g)
{
  return g.target(s);
}

template <typename R, typename S>
auto out_edges(std::uint32_t r, const Region_adjacency_graph<R, S>& g)
{
  const auto range = g.sections(r);
  return std::make_pair(range.begin(), range.end());
}

template <typename R, typename S>
auto adjacent_vertices(std::uint32_t r, const Region_adjacency_graph<R, S>& g)
{
  using Iterator = typename Region_adjacency_graph<R, S>::adjacency_iterator;
  const auto range = g.sections(r);
  return std::make_pair(Iterator(range.begin(), &g), Iterator(range.end(), &g));
}

template <typename R, typename S>
std::size_t out_degree(std::uint32_t r, const Region_adjacency_graph<R, S>& g)
{
  return g.degree(r);
}

template <typename R, typename S>
std::size_t degree(std::uint32_t r, const Region_adjacency_graph<R, S>& g)
{
  return g.degree(r);
}

template <typename R, typename S>
std::pair<Section_descriptor, bool> edge(std::uint32_t a, std::uint32_t b,
                                         const Region_adjacency_graph<R, S>& g)
{
  const auto s = g.section(a, b);
  return {s.value_or(Section_descriptor()), s.has_value()};
}

/// The index of a section, in [0, num_edges()).
struct Section_index_map
{
  using key_type = Section_descriptor;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::readable_property_map_tag;
  friend std::size_t get(Section_index_map, Section_descriptor s) { return s.id(); }
};

/// \ingroup PkgRegionSegmentationGraph
/// A member of the data of the regions or of the sections of a graph, as a property map; see
/// `get()`.
template <typename Graph, typename Descriptor, typename Data, typename Member>
struct Data_member_map
{
  using key_type = Descriptor;
  using value_type = Member;
  using reference = const Member&;
  using category = boost::lvalue_property_map_tag;

  const Graph* graph;
  Member Data::*member;

  reference operator[](key_type key) const { return (*graph)[key].*member; }
  friend reference get(const Data_member_map& map, key_type key) { return map[key]; }
};

/// \ingroup PkgRegionSegmentationGraph
/// The property map of a member of the data of the regions or of the sections:
/// `get(&Region_geometry::area, graph)`. A model of `ReadablePropertyMap`; it is valid as long as
/// the graph.
template <typename R, typename S, typename Data, typename Member>
auto get(Member Data::*member, const Region_adjacency_graph<R, S>& g)
{
  using Graph = Region_adjacency_graph<R, S>;
  static_assert(std::is_base_of<Data, R>::value || std::is_base_of<Data, S>::value,
                "the data of neither the regions nor the sections of the graph have this member");
  using Descriptor = std::conditional_t<std::is_base_of<Data, R>::value,
                                        typename Graph::region_descriptor,
                                        typename Graph::section_descriptor>;
  return Data_member_map<Graph, Descriptor, Data, Member>{&g, member};
}

template <typename R, typename S>
boost::typed_identity_property_map<std::uint32_t> get(boost::vertex_index_t,
                                                      const Region_adjacency_graph<R, S>&)
{
  return {};
}

template <typename R, typename S>
std::uint32_t get(boost::vertex_index_t, const Region_adjacency_graph<R, S>&, std::uint32_t r)
{
  return r;
}

template <typename R, typename S>
Section_index_map get(boost::edge_index_t, const Region_adjacency_graph<R, S>&)
{
  return {};
}

template <typename R, typename S>
std::size_t get(boost::edge_index_t, const Region_adjacency_graph<R, S>&, Section_descriptor s)
{
  return s.id();
}

} // namespace Region_segmentation
} // namespace CGAL

namespace boost {

template <typename R, typename S>
struct property_map<CGAL::Region_segmentation::Region_adjacency_graph<R, S>, vertex_index_t>
{
  using type = typed_identity_property_map<std::uint32_t>;
  using const_type = type;
};

template <typename R, typename S>
struct property_map<CGAL::Region_segmentation::Region_adjacency_graph<R, S>, edge_index_t>
{
  using type = CGAL::Region_segmentation::Section_index_map;
  using const_type = type;
};

// Boost's own forwarding covers its own graphs only.
template <typename R, typename S>
struct property_map<const CGAL::Region_segmentation::Region_adjacency_graph<R, S>, vertex_index_t>
  : property_map<CGAL::Region_segmentation::Region_adjacency_graph<R, S>, vertex_index_t>
{};

template <typename R, typename S>
struct property_map<const CGAL::Region_segmentation::Region_adjacency_graph<R, S>, edge_index_t>
  : property_map<CGAL::Region_segmentation::Region_adjacency_graph<R, S>, edge_index_t>
{};

} // namespace boost

#endif // CGAL_REGION_SEGMENTATION_GRAPH_INTERNAL_REGION_GRAPH_BGL_H
