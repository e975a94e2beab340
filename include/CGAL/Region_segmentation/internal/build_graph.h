// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_BUILD_GRAPH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_BUILD_GRAPH_H

#include <CGAL/Region_segmentation/internal/Large_array.h>
#include <CGAL/Region_segmentation/internal/Region_labels.h>
#include <CGAL/Region_segmentation/internal/Section_finder.h>
#include <CGAL/Region_segmentation/internal/border_edges.h>
#include <CGAL/Region_segmentation/internal/concept_checks.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Adds the sections to which edges belong. Returns the section of each.
template <typename Graph, typename Edges>
Large_array<std::uint32_t> add_sections(Graph& graph, const Flat_mesh& flat, const Region_labels& regions,
                                        const Edges& edges)
{
  Section_finder finder(regions.number_of_regions);
  for (Flat_mesh::Index e : edges)
    finder.count(regions.of_face[flat.lower_face(e)], regions.of_face[flat.higher_face(e)]);
  Large_array<std::uint32_t> result(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i)
    result[i] = finder.find_or_add(regions.of_face[flat.lower_face(edges[i])],
                                   regions.of_face[flat.higher_face(edges[i])]);
  graph.add_sections(finder.sections());
  return result;
}

/// Accounts for all faces. Most often one face after another has the same region: small data is in registers then.
template <typename Graph>
void add_faces(Graph& graph, const Flat_mesh& flat, const Region_labels& regions)
{
  using Data = typename Graph::RegionData;
  constexpr bool is_small =
    std::is_trivially_copyable<Data>::value && std::is_copy_assignable<Data>::value && sizeof(Data) <= 64;
  for (std::size_t f = 0; f < flat.number_of_faces();) {
    const Flat_mesh::Index r = regions.of_face[f];
    std::conditional_t<is_small, Data, Data&> data = graph[r];
    for (; f < flat.number_of_faces() && regions.of_face[f] == r; ++f)
      data.add_face(flat, f);
    if constexpr (is_small)
      graph[r] = data;
  }
}

/// The graph of labelled regions. Sections are numbered by their first dual edge. Sums run over the faces and
/// edges in order. O(F) in practice, see `Section_finder`.
///
/// In parallel the edges between regions are found; on a mesh without noise they are few.
template <typename Graph, typename ConcurrencyTag = CGAL::Sequential_tag>
Graph build_graph(const Flat_mesh& flat, const Region_labels& regions)
{
  check_graph_data<typename Graph::RegionData, typename Graph::SectionData>();
  Graph graph;
  graph.reserve(regions.number_of_regions, 0);
  for (std::size_t r = 0; r < regions.number_of_regions; ++r)
    graph.add_region();
  add_faces(graph, flat, regions);

  const auto edges = border_edges<ConcurrencyTag>(flat, regions);
  const auto section_of = add_sections(graph, flat, regions, edges);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::size_t edge = edges[i], face = flat.lower_face(edge);
    const typename Graph::section_descriptor section(2 * section_of[i]);
    graph[regions.of_face[face]].add_border_edge(flat, face, edge);
    graph[regions.of_face[flat.higher_face(edge)]].add_border_edge(flat, face, edge);
    graph[section].add_edge(flat, face, edge);
    if (flat.has_flag(edge, Flat_mesh::CONSTRAINED))
      graph.forbid_merge(section);
  }
  return graph;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_BUILD_GRAPH_H
