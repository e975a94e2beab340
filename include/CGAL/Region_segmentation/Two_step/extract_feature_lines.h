// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TWO_STEP_EXTRACT_FEATURE_LINES_H
#define CGAL_REGION_SEGMENTATION_TWO_STEP_EXTRACT_FEATURE_LINES_H

#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <CGAL/boost/graph/split_graph_into_polylines.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
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

/// Feature edges as a graph, whose nodes carry vertices of the surface. Several edges of the
/// surface between the same two vertices are one edge of the graph.
using Feature_graph = boost::adjacency_list<boost::setS, boost::vecS, boost::undirectedS,
                                            Surface::Index, Feature_edge_role>;

/// The nodes of the line that starts at a free end, up to the first node that does not have two
/// edges or from which it continues as a barrier; only the free end if it starts as one.
inline std::vector<std::size_t> line_from(std::size_t free_end, const Feature_graph& graph)
{
  std::vector<std::size_t> nodes = {free_end};
  std::size_t previous = free_end, node = free_end;
  do {
    auto next = boost::adjacent_vertices(node, graph).first;
    if (node != free_end && *next == previous)
      ++next;
    if (graph[boost::edge(node, *next, graph).first] == Feature_edge_role::BARRIER)
      break;
    previous = std::exchange(node, *next);
    nodes.push_back(node);
  } while (boost::degree(node, graph) == 2);
  return nodes;
}

/// Removes an edge if it is removable and still exists; returns whether it did.
inline bool remove_if_removable(std::size_t from, std::size_t to, Feature_graph& graph)
{
  const auto e = boost::edge(from, to, graph);
  if (!e.second || graph[e.first] != Feature_edge_role::REMOVABLE)
    return false;
  boost::remove_edge(e.first, graph);
  return true;
}

/// Removes the lines with a free end that have fewer edges than `minimum_length`, except for their
/// fixed edges: all at once, so that the order has no effect, and repeatedly while this creates
/// free ends or extends a line of fixed edges. O(E) without fixed edges: a line that is long enough
/// can only become longer, and is not traversed again.
inline void prune_feature_graph(Feature_graph& graph, std::size_t minimum_length)
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

/// Adds the edges of a surface that are marked, its borders, and the edges that growing does not
/// cross. `node_of`: the node of each vertex, `Surface::none` before it is added
inline void add_feature_edges(const Surface& surface, const std::vector<std::uint8_t>& is_feature,
                              Feature_graph& graph, std::vector<Surface::Index>& node_of)
{
  const auto node = [&](Surface::Index v) {
    return node_of[v] != Surface::none ? node_of[v]
                                       : node_of[v] = Surface::Index(boost::add_vertex(v, graph));
  };
  const auto add = [&](Surface::Index v, Surface::Index w, Feature_edge_role role) {
    const auto [e, is_new] = boost::add_edge(node(v), node(w), role, graph);
    if (!is_new && graph[e] != role)
      graph[e] = Feature_edge_role::FIXED;
  };
  for_each_side_of_surface(surface, [&](auto, auto v, auto w, Surface::Index a) {
    if (v == w)
      return; // a side of no length
    if (a == Surface::none || surface.has_flag(a, Surface::CONSTRAINED))
      add(v, w, Feature_edge_role::FIXED);
    else if (surface.has_flag(a, Surface::barrier)) // a seam
      add(v, w, is_feature[a] ? Feature_edge_role::FIXED : Feature_edge_role::BARRIER);
    else if (is_feature[a])
      add(v, w, Feature_edge_role::REMOVABLE);
    else if (surface.has_flag(a, Surface::CLOSED))
      add(v, w, Feature_edge_role::BARRIER);
  });
}

/// Keeps the marks of the edges that are still in a feature graph, and marks constrained ones.
inline void keep_marks(const Surface& surface, const Feature_graph& graph,
                       const std::vector<Surface::Index>& node_of,
                       std::vector<std::uint8_t>& is_feature)
{
  for_each_side_of_surface(surface, [&](auto, auto v, auto w, Surface::Index a) {
    if (a != Surface::none)
      is_feature[a] = surface.has_flag(a, Surface::CONSTRAINED) ||
                      (is_feature[a] && boost::edge(node_of[v], node_of[w], graph).second);
  });
}

/// Outputs the lines of a feature graph as lists of vertices.
template <typename OutputIterator>
struct Polyline_collector
{
  const Feature_graph& graph;
  OutputIterator output;
  std::vector<Surface::Index> polyline = {};

  void start_new_polyline() { polyline.clear(); }
  void add_node(std::size_t node) { polyline.push_back(graph[node]); }
  void end_polyline()
  {
    if (polyline.size() >= 2) // fewer at a vertex whose lines are removed
      *output++ = polyline;
  }
};

} // namespace internal

/// \ingroup PkgRegionSegmentationStages
/// removes the feature lines of a surface that end inside it, and outputs those that remain.
///
/// A *feature line* is a maximal chain of feature edges between vertices where the number of
/// feature edges is not 2, or a closed chain. Borders of the surface and constrained edges are
/// feature edges, too, and are never removed. A line with an end without another feature edge
/// separates nothing: all such lines are removed at once, repeatedly until there is none. Growing
/// gives the same regions before and after; to this end, a line may also end at an edge of a
/// degenerate face that growing does not cross.
///
/// \tparam PolylineOutputIterator a model of `OutputIterator` that takes
///         `std::vector<Surface::Index>`
/// \param surface the surface
/// \param is_feature by adjacency: 1 for a feature edge, or 0, see `detect_feature_edges()`. Those
///        of removed lines become 0, those of constrained edges 1
/// \param polylines receives the vertices of every line, by their number in the mesh; a closed line
///        ends with its first vertex. Of vertices with equal points along coinciding borders the
///        first one stands for all
/// \param minimum_length lines of at least this number of edges are kept, although they end inside
///        the surface
/// \returns the output iterator
/// \post every remaining line that is shorter than `minimum_length` is closed or ends at other
///       feature edges
///
/// Complexity: O(F). Deterministic.
///
/// Source: \cgalCite{YZWLL14}, section 3.1.
template <typename PolylineOutputIterator>
PolylineOutputIterator
extract_feature_lines(const Surface& surface, std::vector<std::uint8_t>& is_feature,
                      PolylineOutputIterator polylines,
                      std::size_t minimum_length = (std::numeric_limits<std::size_t>::max)())
{
  internal::Feature_graph graph;
  std::vector<Surface::Index> node_of(surface.number_of_vertices(), Surface::none);
  internal::add_feature_edges(surface, is_feature, graph, node_of);
  internal::prune_feature_graph(graph, minimum_length);
  boost::remove_edge_if(
    [&](const auto& e) { return graph[e] == internal::Feature_edge_role::BARRIER; }, graph);
  internal::keep_marks(surface, graph, node_of, is_feature);
  internal::Polyline_collector<PolylineOutputIterator> collector{graph, polylines};
  CGAL::split_graph_into_polylines(graph, collector);
  return collector.output;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_TWO_STEP_EXTRACT_FEATURE_LINES_H
