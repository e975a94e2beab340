// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_BUILD_GRAPH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_BUILD_GRAPH_H

#include <CGAL/Region_segmentation/internal/Region_labels.h>
#include <CGAL/Region_segmentation/internal/concept_checks.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The graph of labelled regions. Sections are numbered by their first dual edge. O(F) expected.
template <typename Graph>
Graph build_graph(const Flat_mesh& flat, const Region_labels& regions)
{
  check_graph_data<typename Graph::RegionData, typename Graph::SectionData>();
  Graph graph;
  graph.reserve(regions.number_of_regions, 0);
  for (std::size_t r = 0; r < regions.number_of_regions; ++r)
    graph.add_region();

  for (std::size_t f = 0; f < flat.number_of_faces(); ++f) {
    const Flat_mesh::Index r = regions.of_face[f];
    graph[r].add_face(flat, f);
    for (std::size_t e = flat.first_edge(f); e < flat.first_edge(f + 1); ++e) {
      const Flat_mesh::Index q = regions.of_face[flat.higher_face(e)];
      if (q == r)
        continue;
      graph[r].add_border_edge(flat, f, e);
      graph[q].add_border_edge(flat, f, e);
      auto section = graph.section(r, q);
      if (!section)
        section = graph.add_section(r, q);
      graph[*section].add_edge(flat, f, e);
      if (flat.has_flag(e, Flat_mesh::CONSTRAINED))
        graph.forbid_merge(*section);
    }
  }
  return graph;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_BUILD_GRAPH_H
