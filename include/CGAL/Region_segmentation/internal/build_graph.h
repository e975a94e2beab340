// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_BUILD_GRAPH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_BUILD_GRAPH_H

#include <CGAL/Region_segmentation/internal/Region_labels.h>
#include <CGAL/Region_segmentation/internal/border_edges.h>
#include <CGAL/Region_segmentation/internal/concept_checks.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

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

/// Accounts for all faces. Most often one face after another has the same region, whose data is at hand then.
template <typename Graph>
void add_faces(Graph& graph, const Flat_mesh& flat, const Region_labels& regions)
{
  for (std::size_t f = 0; f < flat.number_of_faces();) {
    const Flat_mesh::Index r = regions.of_face[f];
    typename Graph::RegionData data = std::move(graph[r]);
    for (; f < flat.number_of_faces() && regions.of_face[f] == r; ++f)
      data.add_face(flat, f);
    graph[r] = std::move(data);
  }
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
  add_faces(graph, flat, regions);

  for (Flat_mesh::Index edge : border_edges<ConcurrencyTag>(flat, regions))
    add_border_edge(graph, flat, regions, edge);
  return graph;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_BUILD_GRAPH_H
