// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_BUILD_REGION_ADJACENCY_GRAPH_H
#define CGAL_REGION_SEGMENTATION_GRAPH_BUILD_REGION_ADJACENCY_GRAPH_H

#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <boost/range/irange.hpp>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

namespace internal {

/// As `build_region_adjacency_graph()`. `adjacencies`: all between two regions, in order; others
/// may be among them
template <typename RegionData, typename SectionData, typename Adjacencies>
Region_adjacency_graph<RegionData, SectionData>
build_region_graph(const Surface& surface, const Partition& regions, const Adjacencies& adjacencies,
                   const Execution& execution)
{
  Region_adjacency_graph<RegionData, SectionData> graph(regions.number_of_parts());
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    graph[regions[f]].add_face(surface, f);
  execution.report(0.3);
  for (const std::size_t i : adjacencies) {
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

/// \ingroup PkgRegionSegmentationStages
/// builds the graph of the regions of a surface and the sections between them.
///
/// \tparam RegionData, SectionData models of `RegionData` and `SectionData`: sums over the faces
///         and adjacencies. Those that need more, such as `Visibility_region_data`, are filled by
///         their annotator afterwards
/// \param surface, regions the region of every face
/// \param execution threads and visitor: reports the progress of the stage that it is of
///
/// \returns a `Region_adjacency_graph`; its regions are the parts of `regions`
/// \throws Invalid_method if `regions` is no partition of the faces
///
/// Sections with a constrained edge are never merged across.
///
/// Complexity: O(F) expected. Deterministic: the sums over a section run by higher, then by lower
/// face.
///
/// Source: \cgalCite{YZWLL14}, section 3.3 (EdgeSection).
template <typename RegionData = Region_geometry, typename SectionData = Section_geometry>
Region_adjacency_graph<RegionData, SectionData>
build_region_adjacency_graph(const Surface& surface, const Partition& regions,
                             const Execution& execution = Execution())
{
  internal::check_regions(regions, surface.number_of_faces());
  return internal::build_region_graph<RegionData, SectionData>(
    surface, regions, boost::irange(std::size_t(0), surface.number_of_adjacencies()), execution);
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_BUILD_REGION_ADJACENCY_GRAPH_H
