// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_BUILD_GRAPH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_BUILD_GRAPH_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/graph/border_edges.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Accounts for all faces. Consecutive faces usually have the same region, so small data stays in registers.
template <typename Graph>
void add_faces(Graph& graph, const Flat_mesh& flat, const Partition& regions)
{
  using Data = typename Graph::RegionData;
  constexpr bool is_small =
    std::is_trivially_copyable<Data>::value && std::is_copy_assignable<Data>::value && sizeof(Data) <= 64;
  for (std::size_t f = 0; f < flat.number_of_faces();) {
    const Flat_mesh::Index r = regions[f];
    std::conditional_t<is_small, Data, Data&> data = graph[r];
    for (; f < flat.number_of_faces() && regions[f] == r; ++f)
      data.add_face(flat, f);
    if constexpr (is_small)
      graph[r] = data;
  }
}

/// Accounts for all edges between two regions, and adds their sections.
template <typename Graph, typename ConcurrencyTag>
void add_border_edges(Graph& graph, const Flat_mesh& flat, const Partition& regions,
                      const Execution<ConcurrencyTag>& execution)
{
  const auto edges = border_edges(flat, regions, execution);
  graph.reserve(regions.number_of_parts(), edges.size());
  for (const Border_key key : edges) {
    const std::size_t face = lower_face_of(key), edge = edge_of(key);
    const Flat_mesh::Index a = regions[face], b = regions[flat.higher_face(edge)];
    const auto found = graph.section(a, b);
    const auto section = found ? *found : graph.add_section(a, b);
    graph[a].add_border_edge(flat, face, edge);
    graph[b].add_border_edge(flat, face, edge);
    graph[section].add_edge(flat, face, edge);
    if (flat.has_flag(edge, Flat_mesh::CONSTRAINED))
      graph.forbid_merge(section);
  }
}

/// The graph of labelled regions. Sections are numbered by their first dual edge. Sums run over the faces and
/// edges in order. O(F) expected.
///
/// Only the search for edges between regions is parallel; on a mesh without noise they are few.
template <typename Graph, typename ConcurrencyTag>
Graph build_graph(const Flat_mesh& flat, const Partition& regions, const Execution<ConcurrencyTag>& execution)
{
  Graph graph;
  graph.reserve(regions.number_of_parts(), 0);
  for (std::size_t r = 0; r < regions.number_of_parts(); ++r)
    graph.add_region();
  add_faces(graph, flat, regions);
  execution.report(0.3);
  add_border_edges(graph, flat, regions, execution.step(0.3, 0.6));
  return graph;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_BUILD_GRAPH_H
