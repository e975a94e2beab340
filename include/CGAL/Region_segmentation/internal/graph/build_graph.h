// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_BUILD_GRAPH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_BUILD_GRAPH_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Request.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/concepts/check_parts.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The graph of regions: sections are numbered by their first adjacency, sums run over faces and
/// adjacencies in order. Sections with a constrained adjacency are not mergeable. O(F) expected.
template <typename RegionData, typename SectionData>
Region_adjacency_graph<RegionData, SectionData>
build_graph(const Surface& surface, const Partition& regions, const Execution& execution)
{
  static_assert(check_graph_data<RegionData, SectionData>());
  Region_adjacency_graph<RegionData, SectionData> graph(regions.number_of_parts());
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    graph[regions[f]].add_face(surface, f);
  execution.report(0.3);
  for (std::size_t i = 0; i < surface.number_of_adjacencies(); ++i) {
    const Surface::Index a = regions[surface.lower_face(i)], b = regions[surface.higher_face(i)];
    if (a == b)
      continue;
    const auto found = graph.section(a, b);
    const auto section = found ? *found : graph.add_section(a, b);
    graph[a].add_border(surface, i);
    graph[b].add_border(surface, i);
    graph[section].add_adjacency(surface, i);
    if (surface.has_flag(i, Surface::CONSTRAINED))
      graph.forbid_merge(section);
  }
  execution.report(1);
  return graph;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_GRAPH_BUILD_GRAPH_H
