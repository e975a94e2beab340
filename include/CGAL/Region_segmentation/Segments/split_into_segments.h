// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_SPLIT_INTO_SEGMENTS_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_SPLIT_INTO_SEGMENTS_H

#include <CGAL/Region_segmentation/internal/segments/Piece_builder.h>
#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>
#include <CGAL/Region_segmentation/internal/support/check_output.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationSegments
/// A segment as a mesh of its own.
///
/// \tparam SegmentMesh the type of this mesh
/// \tparam FaceGraph the type of the mesh that was split
/// \tparam Label the value type of the map of segments
template <typename SegmentMesh, typename FaceGraph, typename Label>
struct Segment_piece
{
  Label segment;
  SegmentMesh mesh;
  /// The face of the input for each face of `mesh`, in iteration order. (In a `CGAL::Surface_mesh`,
  /// that is by index.)
  std::vector<typename boost::graph_traits<FaceGraph>::face_descriptor> faces;
  /// The vertex of the input for each vertex of `mesh`, in iteration order.
  std::vector<typename boost::graph_traits<FaceGraph>::vertex_descriptor> vertices;
};

/// \ingroup PkgRegionSegmentationSegments
/// copies every segment to a mesh of its own.
///
/// Faces keep their order. Around a vertex the faces of a segment may form several fans, where the
/// segment touches itself; each fan has a vertex of its own in the copy, so every copy is a
/// 2-manifold. A segment of several components becomes one mesh of these components.
///
/// \tparam SegmentMesh the type of the copies, a model of `MutableFaceGraph` whose elements are
///         iterated in the order of their creation, with a point map of vertices. Default:
///         `FaceGraph`
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`
/// \tparam FaceSegmentMap a model of `ReadablePropertyMap` with the face descriptor as key and an
///         integral value type of at most 64 bits
/// \tparam PieceOutputIterator a model of `OutputIterator` that takes `Segment_piece<SegmentMesh,
///         FaceGraph, Label>`, `Label` the value type of `FaceSegmentMap`
/// \param mesh an oriented 2-manifold with or without boundary, its faces polygons of any size
/// \param segment_map the segments, by any labels; faces with the label `no_segment` are not copied
/// \param pieces receives the copies, in the order of the first faces of the segments
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{edges along which the copies are cut open, such as the seams of
///       `mark_segment_seams()`: then every component of a segment becomes a disc}
///     \cgalParamType{a model of `ReadablePropertyMap` with the edge descriptor as key type and a
///       value type convertible to `bool`}
///     \cgalParamDefault{no edge}
///   \cgalParamNEnd
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
///   \cgalParamIndexMap{halfedge}
/// \cgalNamedParamsEnd
///
/// \returns the number of segments
///
/// Complexity: O(F + V) for all segments together. Read-only; concurrent calls are safe.
template <typename SegmentMesh = void, typename FaceGraph, typename FaceSegmentMap,
          typename PieceOutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t split_into_segments(const FaceGraph& mesh, const FaceSegmentMap& segment_map,
                                PieceOutputIterator pieces,
                                const NamedParameters& np = parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Target = std::conditional_t<std::is_void<SegmentMesh>::value, FaceGraph, SegmentMesh>;
  using Label = typename boost::property_traits<FaceSegmentMap>::value_type;
  static_assert(internal::check_output_of_labels<PieceOutputIterator,
                                                 Segment_piece<Target, FaceGraph, Label>>());
  const auto& pack = internal::pack(np);
  using Pack = std::decay_t<decltype(pack)>;
  internal::check_parameters<Pack, internal::Tag_list<CGAL::internal_np::edge_is_constrained_t>>();
  internal::Segmented_mesh segmented(mesh, segment_map, pack);
  if constexpr (!CGAL::parameters::is_default_parameter<
                  Pack, CGAL::internal_np::edge_is_constrained_t>::value) {
    const auto is_cut = get_parameter(pack, CGAL::internal_np::edge_is_constrained);
    for (std::uint32_t h = 0; h < segmented.size(); ++h)
      if (get(is_cut, edge(segmented.descriptors[h], mesh)))
        segmented.cut(h);
  }
  const auto points = choose_parameter(get_parameter(pack, CGAL::internal_np::vertex_point),
                                       get_const_property_map(CGAL::vertex_point, mesh));
  const internal::Elements_of_graph<FaceGraph, std::decay_t<decltype(points)>> elements{
    mesh, segmented.descriptors, points};
  internal::Piece_builder<Target> builder(segmented);
  for (std::size_t s = 0; s < segmented.number_of_segments; ++s) {
    Segment_piece<Target, FaceGraph, Label> piece;
    piece.segment = segmented.labels[s];
    builder.build(s, elements, piece);
    *pieces++ = std::move(piece);
  }
  return segmented.number_of_segments;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_SPLIT_INTO_SEGMENTS_H
