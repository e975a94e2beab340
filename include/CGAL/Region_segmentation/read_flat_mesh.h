// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_READ_FLAT_MESH_H
#define CGAL_REGION_SEGMENTATION_READ_FLAT_MESH_H

#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/reading/Flat_mesh_reader.h>
#include <CGAL/Region_segmentation/internal/support/visitor.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <type_traits>

namespace CGAL {
namespace Region_segmentation {

namespace internal {

/// The flat mesh of a face graph and its constrained edges.
template <typename ConcurrencyTag, typename FaceGraph, typename Pack>
Flat_mesh read_flat_mesh(const Mesh_traversal<FaceGraph, Pack>& traversal, const Pack& np, Mesh_data data)
{
  const auto execution = make_execution<ConcurrencyTag>(np, "reading");
  return Flat_mesh_reader<ConcurrencyTag, FaceGraph, Pack>(traversal, np, data, execution).read();
}

} // namespace internal

/// \ingroup PkgRegionSegmentationStages
/// reads a mesh into arrays, on which the parts of methods work.
///
/// \tparam ConcurrencyTag `Sequential_tag` or, with TBB, `Parallel_tag`; see `segment()`
/// \tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param mesh an oriented 2-manifold with or without boundary, its faces polygons of any size
/// \param data the data to be read in addition to normals, areas, lengths and angles
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{edges that always are borders and are never merged across}
///     \cgalParamType{a model of `ReadablePropertyMap` with the edge descriptor as key type and a value type convertible
///       to `bool`}
///     \cgalParamDefault{no edge}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{follows the progress, and can cancel: stages "reading"}
///     \cgalParamType{a model of `SegmentationVisitor`}
///     \cgalParamDefault{none}
///     \cgalParamExtra{pass it by `std::ref()` if it changes}
///   \cgalParamNEnd
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
/// \cgalNamedParamsEnd
///
/// \throws Invalid_input if a point is not finite, or the mesh has 2^32 - 1 halfedges or more;
///         `Segmentation_cancelled` if the visitor cancels
///
/// Complexity: O(F). Deterministic: identical results from every mesh type. Read-only; concurrent calls are safe.
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename FaceGraph,
          typename NamedParameters = parameters::Default_named_parameters>
Flat_mesh read_flat_mesh(const FaceGraph& mesh, Mesh_data data = Mesh_data::NOTHING_MORE,
                         const NamedParameters& np = parameters::default_values())
{
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Reading_parameters>();
  return internal::read_flat_mesh<ConcurrencyTag>(internal::make_mesh_traversal(mesh, pack), pack, data);
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_READ_FLAT_MESH_H
