// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_PRUNE_FEATURE_GRAPH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_PRUNE_FEATURE_GRAPH_H

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
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
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_REGIONS_PRUNE_FEATURE_GRAPH_H
