// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_BUILD_REGION_ADJACENCY_GRAPH_H
#define CGAL_REGION_SEGMENTATION_GRAPH_BUILD_REGION_ADJACENCY_GRAPH_H

#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/Partition.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/face_values.h>
#include <CGAL/Region_segmentation/Surface/internal/Face_graph_input.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Region_segmentation {

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
/// Complexity: O(F) expected. Deterministic: the sums over a section run by higher, then by lower
/// face.
template <typename RegionData = Region_geometry, typename SectionData = Section_geometry>
Region_adjacency_graph<RegionData, SectionData>
build_region_adjacency_graph(const Surface& surface, const Partition& regions,
                             const Execution& execution = Execution())
{
  internal::check_regions(regions, surface.number_of_faces());
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

/// \ingroup PkgRegionSegmentationStages
/// builds the graph of the regions of a mesh and the sections between them. (Of a surface that was
/// read in parallel, see above.)
///
/// \tparam RegionData, SectionData see above
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`; also of
///         `EdgeListGraph` where there is an `edge_is_constrained_map`
/// \tparam FaceRegionMap a model of `ReadablePropertyMap` with the face descriptor as key and an
///         integral value type
/// \param mesh see `segment()`
/// \param region_map the region of every face, by any labels: regions are numbered by their first
///        face
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{edges that are never merged across}
///     \cgalParamType{a model of `ReadablePropertyMap` with the edge descriptor as key type and a
///       value type convertible to `bool`}
///     \cgalParamDefault{no edge}
///   \cgalParamNEnd
///   \cgalParamNBegin{component_links}
///     \cgalParamDescription{whether components that touch or are near each other are adjacent, see
///       `Surface`}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{follows the progress, and can cancel: stages "reading", "graph"}
///     \cgalParamType{a model of `SegmentationVisitor`}
///     \cgalParamDefault{none}
///     \cgalParamExtra{passed by `std::ref()`}
///   \cgalParamNEnd
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
/// \cgalNamedParamsEnd
///
/// \throws Invalid_input if a point is not finite, Segmentation_cancelled if the visitor cancels
///
/// Source: \cgalCite{YZWLL14}, section 3.3 (EdgeSection).
template <typename RegionData = Region_geometry, typename SectionData = Section_geometry,
          typename FaceGraph, typename FaceRegionMap,
          typename NamedParameters = parameters::Default_named_parameters>
Region_adjacency_graph<RegionData, SectionData>
build_region_adjacency_graph(const FaceGraph& mesh, FaceRegionMap region_map,
                             const NamedParameters& np = parameters::default_values())
{
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Reading_parameters>();
  const Execution execution = internal::make_execution<CGAL::Sequential_tag>(pack);
  const Surface surface = internal::constrained(internal::Face_graph_input<FaceGraph>(mesh),
                                                internal::make_surface(mesh, pack, execution),
                                                pack);
  return build_region_adjacency_graph<RegionData, SectionData>(
    surface, internal::read_face_labels(mesh, region_map), execution.stage("graph"));
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_BUILD_REGION_ADJACENCY_GRAPH_H
