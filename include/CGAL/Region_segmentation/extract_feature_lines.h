// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXTRACT_FEATURE_LINES_H
#define CGAL_REGION_SEGMENTATION_EXTRACT_FEATURE_LINES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/segmenting/Face_graph_input.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/split_graph_into_polylines.h>
#include <CGAL/tags.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// What pruning may do to an edge.
enum class Feature_edge_role {
  REMOVABLE, ///< a feature edge
  FIXED,     ///< a feature edge that is a border of the mesh or constrained
  BARRIER    ///< not a feature edge, but never crossed by growing: keeps lines that end at it
};

template <typename FaceGraph>
struct Feature_edge
{
  typename boost::graph_traits<FaceGraph>::edge_descriptor mesh_edge;
  Feature_edge_role role;
};

/// Feature edges as a graph; nodes and edges carry the descriptors of the mesh.
template <typename FaceGraph>
using Feature_graph = boost::adjacency_list<
  boost::vecS, boost::vecS, boost::undirectedS,
  typename boost::graph_traits<FaceGraph>::vertex_descriptor, Feature_edge<FaceGraph>>;

/// The nodes of the line that starts at a free end, up to the first node that does not have two
/// edges or from which it continues as a barrier; only the free end if it starts as one.
template <typename Graph>
std::vector<std::size_t> line_from(std::size_t free_end, const Graph& graph)
{
  std::vector<std::size_t> nodes = {free_end};
  std::size_t previous = free_end, node = free_end;
  do {
    auto next = boost::adjacent_vertices(node, graph).first;
    if (node != free_end && *next == previous)
      ++next;
    if (graph[boost::edge(node, *next, graph).first].role == Feature_edge_role::BARRIER)
      break;
    previous = std::exchange(node, *next);
    nodes.push_back(node);
  } while (boost::degree(node, graph) == 2);
  return nodes;
}

/// Removes an edge if it is removable and still exists; returns whether it did.
template <typename Graph>
bool remove_if_removable(std::size_t from, std::size_t to, Graph& graph)
{
  const auto e = boost::edge(from, to, graph);
  if (!e.second || graph[e.first].role != Feature_edge_role::REMOVABLE)
    return false;
  boost::remove_edge(e.first, graph);
  return true;
}

/// Removes the lines with a free end that have fewer edges than `minimum_length`, except for their
/// fixed edges: all at once, so that the order has no effect, and repeatedly while this creates
/// free ends or extends a line of fixed edges. O(E) without fixed edges: a line that is long enough
/// can only become longer, and is not traversed again.
template <typename Graph>
void prune_feature_graph(Graph& graph, std::size_t minimum_length)
{
  const auto is_free = [&graph](std::size_t node) { return boost::degree(node, graph) == 1; };
  std::vector<std::size_t> free_ends;
  for (std::size_t node = 0; node < boost::num_vertices(graph); ++node)
    if (is_free(node))
      free_ends.push_back(node);

  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    std::vector<std::vector<std::size_t>> short_lines;
    for (std::size_t node : free_ends) {
      auto line = line_from(node, graph);
      if (line.size() > 1 && line.size() - 1 < minimum_length)
        short_lines.push_back(std::move(line));
    }
    free_ends.clear();
    for (const auto& line : short_lines) {
      for (std::size_t i = 1; i < line.size(); ++i)
        is_changed |= remove_if_removable(line[i - 1], line[i], graph);
      free_ends.insert(free_ends.end(), line.begin(), line.end());
    }
    free_ends.erase(std::remove_if(free_ends.begin(), free_ends.end(), std::not_fn(is_free)),
                    free_ends.end());
  }
}

/// Keeps only the feature edges.
template <typename Graph>
void remove_barriers(Graph& graph)
{
  boost::remove_edge_if(
    [&graph](const auto& e) { return graph[e].role == Feature_edge_role::BARRIER; }, graph);
}

} // namespace internal

namespace internal {

using Feature_line_parameters = Tag_list<
  CGAL::internal_np::minimum_length_t, internal_np::component_links_t,
  CGAL::internal_np::edge_is_constrained_t, CGAL::internal_np::visitor_t>;

/// The marked edges of a mesh, its borders, and the unmarked edges that are barriers for growing,
/// with their vertices as a graph.
template <typename FaceGraph, typename Pack, typename EdgeIsFeatureMap>
auto make_feature_graph(const Stage_input<FaceGraph, Pack>& input,
                        const EdgeIsFeatureMap& edge_is_feature_map)
{
  constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  const FaceGraph& mesh = input.mesh();
  Feature_graph<FaceGraph> graph;
  std::vector<std::size_t> node_of(input.surface().number_of_vertices(), none);
  const auto node = [&](auto v) {
    std::size_t& n = node_of[input.rank(v)];
    return n == none ? n = add_vertex(v, graph) : n;
  };
  const auto add = [&](auto h, Feature_edge_role role) {
    const std::size_t from = node(source(h, mesh)), to = node(target(h, mesh));
    add_edge(from, to, {edge(h, mesh), role}, graph);
  };

  input.for_each_edge([&](auto h, Surface::Index a) {
    const bool is_border = CGAL::is_border(edge(h, mesh), mesh);
    if (a == Surface::none ? is_border : input.is_constrained(a))
      add(h, Feature_edge_role::FIXED);
    else if (a == Surface::none)
      return;
    else if (get(edge_is_feature_map, edge(h, mesh)))
      add(h, Feature_edge_role::REMOVABLE);
    else if (input.surface().has_flag(a, Surface::CLOSED))
      add(h, Feature_edge_role::BARRIER);
  });
  return graph;
}

/// Outputs the lines of a feature graph as lists of mesh vertices.
template <typename Graph, typename OutputIterator>
struct Polyline_collector
{
  const Graph& graph;
  OutputIterator& output;
  std::size_t& count;
  std::vector<typename boost::vertex_bundle_type<Graph>::type> polyline = {};

  void start_new_polyline() { polyline.clear(); }
  void add_node(std::size_t node) { polyline.push_back(graph[node]); }
  void end_polyline()
  {
    if (polyline.size() < 2) // a vertex whose lines are removed
      return;
    *output++ = polyline;
    ++count;
  }
};

} // namespace internal

/// \ingroup PkgRegionSegmentationStages
/// removes the feature lines that end inside the surface, and outputs those that remain.
///
/// A *feature line* is a maximal chain of feature edges between vertices where the number of
/// feature edges is not 2, or a closed chain. A line with an end without another feature edge
/// separates nothing: all such lines are removed at once, repeatedly until there is none. Growing
/// gives the same regions before and after; to this end, a line may also end at an edge of a
/// degenerate face that growing does not cross.
///
/// \tparam ConcurrencyTag `Sequential_tag` or, with TBB, `Parallel_tag`; see `segment()`
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph`, `VertexListGraph` and
///         `EdgeListGraph`
/// \tparam EdgeIsFeatureMap a model of `ReadWritePropertyMap` with the edge descriptor as key and a
///         value type convertible to and constructible from `bool`
/// \tparam PolylineOutputIterator a model of `OutputIterator` that takes
///         `std::vector<vertex_descriptor>`
/// \param mesh an oriented 2-manifold with or without boundary
/// \param edge_is_feature_map the feature edges; every key is written. Borders of the
///        surface are always feature edges
/// \param polylines receives the vertices of every line; a closed one ends with its first vertex
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{minimum_length}
///     \cgalParamDescription{lines of at least this number of edges are kept, although they end
///       inside the surface}
///     \cgalParamType{an integral type}
///     \cgalParamDefault{no line is that long}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{feature edges that are never removed}
///     \cgalParamType{a model of `ReadablePropertyMap` with the edge descriptor as key type and a
///       value type convertible to `bool`}
///     \cgalParamDefault{no edge}
///   \cgalParamNEnd
///   \cgalParamNBegin{component_links}
///     \cgalParamDescription{whether border edges with equal end points are one edge; other links
///       have no effect here}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{follows the progress, and can cancel: stages "reading"}
///     \cgalParamType{a model of `SegmentationVisitor`}
///     \cgalParamDefault{none}
///     \cgalParamExtra{passed by `std::ref()`}
///   \cgalParamNEnd
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
/// \cgalNamedParamsEnd
///
/// \returns the number of lines that remain
/// \post every remaining line that is shorter than `minimum_length` is closed or ends at other
///       feature edges
/// \throws Invalid_input if a point is not finite, Segmentation_cancelled if the visitor cancels;
///         the map is unchanged
///
/// Complexity: O(F). Deterministic. Concurrent calls on different maps are safe.
///
/// Source: \cgalCite{YZWLL14}, section 3.1.
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename FaceGraph,
          typename EdgeIsFeatureMap, typename PolylineOutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t extract_feature_lines(const FaceGraph& mesh, EdgeIsFeatureMap edge_is_feature_map,
                                  PolylineOutputIterator polylines,
                                  const NamedParameters& np = parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Value = typename boost::property_traits<EdgeIsFeatureMap>::value_type;
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Feature_line_parameters>();
  const std::size_t minimum_length = choose_parameter(
    get_parameter(pack, CGAL::internal_np::minimum_length),
    (std::numeric_limits<std::size_t>::max)());

  const internal::Stage_input input(mesh, pack, internal::make_execution<ConcurrencyTag>(pack));
  auto graph = internal::make_feature_graph(input, edge_is_feature_map);
  internal::prune_feature_graph(graph, minimum_length);
  internal::remove_barriers(graph);

  for (auto e : edges(mesh))
    put(edge_is_feature_map, e, Value(false));
  for (auto range = boost::edges(graph); range.first != range.second; ++range.first)
    put(edge_is_feature_map, graph[*range.first].mesh_edge, Value(true));

  std::size_t number_of_lines = 0;
  internal::Polyline_collector<decltype(graph), PolylineOutputIterator> collector{graph, polylines,
                                                                                  number_of_lines};
  CGAL::split_graph_into_polylines(graph, collector);
  return number_of_lines;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_EXTRACT_FEATURE_LINES_H
