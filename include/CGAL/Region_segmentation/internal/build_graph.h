// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_BUILD_GRAPH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_BUILD_GRAPH_H

#include <CGAL/Region_segmentation/internal/Region_labels.h>
#include <CGAL/Region_segmentation/internal/blocks.h>
#include <CGAL/Region_segmentation/internal/concept_checks.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Calls `f(edge)` for the dual edges `begin` .. `end - 1` that are between two regions, in order.
template <typename F>
void for_each_border_edge(const Flat_mesh& flat, const Region_labels& regions, std::size_t begin,
                          std::size_t end, const F& f)
{
  for (std::size_t e = begin; e < end; ++e)
    if (regions.of_face[flat.lower_face(e)] != regions.of_face[flat.higher_face(e)])
      f(e);
}

/// Accounts for a dual edge between two regions.
template <typename Graph>
void add_border_edge(Graph& graph, const Flat_mesh& flat, const Region_labels& regions, std::size_t edge)
{
  const std::size_t face = flat.lower_face(edge);
  const Flat_mesh::Index r = regions.of_face[face], q = regions.of_face[flat.higher_face(edge)];
  graph[r].add_border_edge(flat, face, edge);
  graph[q].add_border_edge(flat, face, edge);
  auto section = graph.section(r, q);
  if (!section)
    section = graph.add_section(r, q);
  graph[*section].add_edge(flat, face, edge);
  if (flat.has_flag(edge, Flat_mesh::CONSTRAINED))
    graph.forbid_merge(*section);
}

/// The graph of labelled regions. Sections are numbered by their first dual edge. O(F) expected.
///
/// Sums run over the faces and edges in order. In parallel the edges between regions are found; on a mesh
/// without noise they are few.
template <typename Graph, typename ConcurrencyTag = CGAL::Sequential_tag>
Graph build_graph(const Flat_mesh& flat, const Region_labels& regions)
{
  check_graph_data<typename Graph::RegionData, typename Graph::SectionData>();
  Graph graph;
  graph.reserve(regions.number_of_regions, 0);
  for (std::size_t r = 0; r < regions.number_of_regions; ++r)
    graph.add_region();
  for (std::size_t f = 0; f < flat.number_of_faces(); ++f)
    graph[regions.of_face[f]].add_face(flat, f);

  const std::size_t size = flat.number_of_edges();
  const auto add = [&](std::size_t edge) { add_border_edge(graph, flat, regions, edge); };
  if constexpr (is_parallel<ConcurrencyTag>) {
    std::vector<std::vector<Flat_mesh::Index>> found(number_of_blocks(size));
    for_each_block<ConcurrencyTag>(size, [&](std::size_t block, std::size_t begin, std::size_t end) {
      for_each_border_edge(flat, regions, begin, end,
                           [&](std::size_t edge) { found[block].push_back(Flat_mesh::Index(edge)); });
    });
    for (const auto& of_block : found)
      std::for_each(of_block.begin(), of_block.end(), add);
  } else
    for_each_border_edge(flat, regions, 0, size, add);
  return graph;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_BUILD_GRAPH_H
