// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_BUILD_GRAPH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_BUILD_GRAPH_H

#include <CGAL/Region_segmentation/internal/Region_labels.h>
#include <CGAL/Region_segmentation/internal/blocks.h>
#include <CGAL/Region_segmentation/internal/concept_checks.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Calls `f(face, edge)` for the dual edges of the faces `begin` .. `end - 1` between two regions, in order.
template <typename F>
void for_each_border_edge(const Flat_mesh& flat, const Region_labels& regions, std::size_t begin,
                          std::size_t end, const F& f)
{
  for (std::size_t face = begin; face < end; ++face)
    for (std::size_t e = flat.first_edge(face); e < flat.first_edge(face + 1); ++e)
      if (regions.of_face[face] != regions.of_face[flat.higher_face(e)])
        f(face, e);
}

/// Accounts for a dual edge between two regions.
template <typename Graph>
void add_border_edge(Graph& graph, const Flat_mesh& flat, const Region_labels& regions, std::size_t face,
                     std::size_t edge)
{
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
  const std::size_t size = flat.number_of_faces();
  Graph graph;
  graph.reserve(regions.number_of_regions, 0);
  for (std::size_t r = 0; r < regions.number_of_regions; ++r)
    graph.add_region();
  for (std::size_t f = 0; f < size; ++f)
    graph[regions.of_face[f]].add_face(flat, f);

  const auto add = [&](std::size_t face, std::size_t edge) {
    add_border_edge(graph, flat, regions, face, edge);
  };
  if constexpr (is_parallel<ConcurrencyTag>) {
    using Index = Flat_mesh::Index;
    std::vector<std::vector<std::pair<Index, Index>>> found(number_of_blocks(size)); // face, edge
    for_each_block<ConcurrencyTag>(size, [&](std::size_t block, std::size_t begin, std::size_t end) {
      for_each_border_edge(flat, regions, begin, end, [&](std::size_t face, std::size_t edge) {
        found[block].emplace_back(Index(face), Index(edge));
      });
    });
    for (const auto& of_block : found)
      for (const auto& [face, edge] : of_block)
        add(face, edge);
  } else
    for_each_border_edge(flat, regions, 0, size, add);
  return graph;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_BUILD_GRAPH_H
