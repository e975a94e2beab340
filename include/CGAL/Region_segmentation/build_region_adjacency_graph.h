// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_BUILD_REGION_ADJACENCY_GRAPH_H
#define CGAL_REGION_SEGMENTATION_BUILD_REGION_ADJACENCY_GRAPH_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Graph/Region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Methods/Geometry_annotator.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/internal/segmenting/check_annotator.h>
#include <CGAL/Region_segmentation/internal/segmenting/check_method.h>
#include <CGAL/Region_segmentation/internal/graph/build_graph.h>
#include <CGAL/Region_segmentation/internal/support/read_face_labels.h>
#include <CGAL/Region_segmentation/internal/support/visitor.h>
#include <CGAL/Region_segmentation/parameters.h>
#include <CGAL/Region_segmentation/read_flat_mesh.h>

#include <CGAL/tags.h>

#include <string>
#include <type_traits>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationStages
/// builds the graph of the regions of a flat mesh and the sections between them, with the data of an annotator.
///
/// \tparam GraphAnnotator a model of `GraphAnnotator`
/// \param mesh what `read_flat_mesh()` made, with the data that the annotator needs
/// \param regions the region of every face
/// \param annotator fills the data
/// \param execution how it runs, and who follows its progress
///
/// \returns a `Region_adjacency_graph` with the data of the annotator; its regions are the parts of `regions`
/// \throws Invalid_input if the numbers of elements of `regions` and of faces differ
///
/// Complexity: O(F) where regions are connected and the surface has few handles, O(F sqrt(F)) at worst; and that of the
/// annotator. Deterministic: the sums over the edges of a section run by lower, then by higher face.
template <typename GraphAnnotator, typename ConcurrencyTag = CGAL::Sequential_tag>
auto build_region_adjacency_graph(const Flat_mesh& mesh, const Partition& regions, const GraphAnnotator& annotator,
                                  const Execution<ConcurrencyTag>& execution = Execution<ConcurrencyTag>())
{
  static_assert(internal::check_graph_annotator<GraphAnnotator>());
  if (regions.size() != mesh.number_of_faces())
    throw Invalid_input("a partition of " + std::to_string(regions.size()) + " elements for " +
                        std::to_string(mesh.number_of_faces()) + " faces");
  auto graph = internal::build_graph<internal::Graph_of<GraphAnnotator>>(mesh, regions, execution.step(0, 0.1));
  typename internal::Cache_of<GraphAnnotator>::type cache;
  internal::annotate(annotator, graph, mesh, regions, execution.step(0.1, 1), cache);
  return graph;
}

/// \ingroup PkgRegionSegmentationStages
/// builds the graph of the regions of a mesh and the sections between them.
///
/// \tparam ConcurrencyTag `Sequential_tag` or, with TBB, `Parallel_tag`; see `segment()`
/// \tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam FaceRegionMap a model of `ReadablePropertyMap` with the face descriptor as key and an
///         integral value type
/// \tparam GraphAnnotator a model of `GraphAnnotator`
/// \param mesh an oriented 2-manifold with or without boundary
/// \param region_map the region of every face, by any labels: regions are numbered by their first face
/// \param annotator defines the data of the graph, and fills them
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{edges that are never merged across}
///     \cgalParamType{a model of `ReadablePropertyMap` with the edge descriptor as key type and a value type convertible
///       to `bool`}
///     \cgalParamDefault{no edge}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{follows the progress, and can cancel: stages "reading", "graph"}
///     \cgalParamType{a model of `SegmentationVisitor`}
///     \cgalParamDefault{none}
///     \cgalParamExtra{pass it by `std::ref()` if it changes}
///   \cgalParamNEnd
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
/// \cgalNamedParamsEnd
///
/// \throws Invalid_input if a point is not finite, Segmentation_cancelled if the visitor cancels
///
/// Complexity: O(F) where regions are connected and the surface has few handles, O(F sqrt(F)) at worst; and that of the
/// annotator. Deterministic: the sums over the edges of a section run by lower, then by higher face, for every mesh
/// type.
///
/// Source: \cgalCite{YZWLL14}, section 3.3 (EdgeSection).
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename FaceGraph, typename FaceRegionMap,
          typename GraphAnnotator, typename NamedParameters = parameters::Default_named_parameters,
          typename = internal::Names_data<GraphAnnotator>>
auto build_region_adjacency_graph(const FaceGraph& mesh, FaceRegionMap region_map, const GraphAnnotator& annotator,
                                  const NamedParameters& np = parameters::default_values())
{
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Reading_parameters>();
  static_assert(internal::check_graph_annotator<GraphAnnotator>());
  using Graph = internal::Graph_of<GraphAnnotator>;
  constexpr Mesh_data data = internal::mesh_data_of<GraphAnnotator>() |
                             internal::mesh_data_of<typename Graph::RegionData>() |
                             internal::mesh_data_of<typename Graph::SectionData>();
  const Flat_mesh flat =
    internal::read_flat_mesh<ConcurrencyTag>(internal::make_mesh_traversal(mesh, pack), pack, data);
  return build_region_adjacency_graph(flat, internal::read_face_labels(mesh, region_map), annotator,
                                      internal::make_execution<ConcurrencyTag>(pack, "graph"));
}

/// \ingroup PkgRegionSegmentationStages
/// As above, with the lengths, angles and areas of `Geometry_annotator`.
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename FaceGraph, typename FaceRegionMap,
          typename NamedParameters = parameters::Default_named_parameters,
          typename = std::enable_if_t<!internal::satisfies<internal::Names_data, NamedParameters>>>
Region_adjacency_graph<> build_region_adjacency_graph(const FaceGraph& mesh, FaceRegionMap region_map,
                                                      const NamedParameters& np = parameters::default_values())
{
  return build_region_adjacency_graph<ConcurrencyTag>(mesh, region_map, Geometry_annotator<>(), np);
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_BUILD_REGION_ADJACENCY_GRAPH_H
