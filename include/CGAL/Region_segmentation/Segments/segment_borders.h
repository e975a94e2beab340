// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_SEGMENT_BORDERS_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_SEGMENT_BORDERS_H

#include <CGAL/Region_segmentation/Segments/internal/Segmented_mesh.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Support/parameters.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Calls `f(halfedges, is_closed)` for the borders between segments: from junction to junction,
/// then for the closed ones, each kind by its first halfedges. An edge is represented by its
/// halfedge in the segment of lower number, so that the borders between two segments run in one
/// direction.
template <typename F>
void for_each_border(const Segmented_halfedges& mesh, const F& f)
{
  using Index = Segmented_halfedges::Index;
  std::vector<Index> leaving(mesh.number_of_vertices), degrees(mesh.number_of_vertices, 0);
  std::vector<char> is_waiting(mesh.size(), false);
  for (Index h = 0; h < mesh.size(); ++h)
    if (mesh.segment(h) < mesh.segment_across(h)) {
      is_waiting[h] = mesh.opposite[h] != mesh.none;
      leaving[mesh.source[h]] = h;
      for (const Index v : {mesh.source[h], mesh.target(h)})
        degrees[v] += is_waiting[h] ? 1u : 3u; // vertices on the border of the mesh are junctions
    }
  // At a vertex of degree 2 both edges separate the same segments: one arrives, the other leaves.
  for (const bool is_closed : {false, true})
    for (Index first = 0; first < mesh.size(); ++first)
      if (is_waiting[first] && (is_closed || degrees[mesh.source[first]] != 2)) {
        std::vector<Index> border;
        for (Index h = first; is_waiting[h]; h = leaving[mesh.target(h)]) {
          is_waiting[h] = false;
          border.push_back(h);
          if (degrees[mesh.target(h)] != 2)
            break;
        }
        f(border, is_closed);
      }
}

} // namespace internal

/// \ingroup PkgRegionSegmentationSegments
/// A polyline between two segments.
///
/// \tparam FaceGraph the type of the mesh
/// \tparam Label the value type of the map of segments
template <typename FaceGraph, typename Label>
struct Segment_border
{
  using halfedge_descriptor = typename boost::graph_traits<FaceGraph>::halfedge_descriptor;

  Label segment;          ///< to the left, seen from outside; of the two, that with the first face
  Label opposite_segment; ///< to the right; `no_segment` if these faces have none
  /// At least one; the target of each is the source of the next one.
  std::vector<halfedge_descriptor> halfedges;
  /// Whether the polyline is a closed one without junctions. (One that begins and ends at the same
  /// junction is not.)
  bool is_closed;
};

/// \ingroup PkgRegionSegmentationSegments
/// outputs the borders between segments as polylines from junction to junction, and closed ones.
///
/// A *junction* is a vertex where the number of edges between segments is not 2, or on the border
/// of the mesh. Every edge that `mark_segment_borders()` marks is in one polyline.
///
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`
/// \tparam FaceSegmentMap a model of `ReadablePropertyMap` with the face descriptor as key and an
///         integral value type of at most 64 bits
/// \tparam BorderOutputIterator a model of `OutputIterator` that takes `Segment_border<FaceGraph,
///         Label>`, `Label` the value type of `FaceSegmentMap`
/// \param mesh an oriented 2-manifold with or without boundary, its faces polygons of any size
/// \param segment_map the segments, by any labels; faces with the label `no_segment` belong to none
/// \param borders receives the polylines, in the order of their first faces: open ones, then closed
///        ones
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
///   \cgalParamIndexMap{halfedge}
/// \cgalNamedParamsEnd
///
/// \returns the output iterator
///
/// Complexity: O(F log d), d the number of corners of a face. Deterministic: the same polylines
/// from every mesh type. Read-only; concurrent calls are safe.
template <typename FaceGraph, typename FaceSegmentMap, typename BorderOutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
BorderOutputIterator
extract_segment_borders(const FaceGraph& mesh, const FaceSegmentMap& segment_map,
                        BorderOutputIterator borders,
                        const NamedParameters& np = parameters::default_values())
{
  using Border = Segment_border<FaceGraph,
                                typename boost::property_traits<FaceSegmentMap>::value_type>;
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Tag_list<>>();
  const auto segmented = internal::read_segmented_mesh(mesh, segment_map, pack);
  internal::for_each_border(segmented, [&](const auto& halfedges, bool is_closed) {
    const auto h = halfedges.front();
    Border border{segmented.label(segmented.segment(h)),
                  segmented.label(segmented.segment_across(h)),
                  {},
                  is_closed};
    for (auto i : halfedges)
      border.halfedges.push_back(segmented.halfedges[i]);
    *borders++ = std::move(border);
  });
  return borders;
}

/// \ingroup PkgRegionSegmentationSegments
/// marks the edges between different segments: the map that remeshing and simplification take as
/// constrained edges.
///
/// The constrained edges of a segmentation are marked where they separate two segments; those
/// inside a segment are not.
///
/// Faces without a segment (`no_segment`) count as one more segment. Edges on the border of the
/// mesh separate no two segments and are not marked: functions of \cgal that protect constrained
/// edges know borders, or have a parameter for them.
///
/// \tparam FaceGraph a model of `FaceGraph` and `EdgeListGraph`
/// \tparam FaceSegmentMap a model of `ReadablePropertyMap` with the face descriptor as key and an
///         equality comparable value type
/// \tparam EdgeIsBorderMap a model of `WritablePropertyMap` with the edge descriptor as key and a
///         value type constructible from `bool`
/// \param mesh an oriented 2-manifold with or without boundary, its faces polygons of any size
/// \param segment_map the segments, by any labels
/// \param edge_is_border_map every key is written
///
/// \returns the number of marked edges
///
/// Complexity: O(E). Concurrent calls on different maps are safe.
template <typename FaceGraph, typename FaceSegmentMap, typename EdgeIsBorderMap>
std::size_t mark_segment_borders(const FaceGraph& mesh, const FaceSegmentMap& segment_map,
                                 EdgeIsBorderMap edge_is_border_map)
{
  static_assert(internal::check_face_map<FaceSegmentMap, FaceGraph>());
  static_assert(internal::check_edge_map<EdgeIsBorderMap, FaceGraph>());
  using Value = typename boost::property_traits<EdgeIsBorderMap>::value_type;
  std::size_t count = 0;
  for (auto e : edges(mesh)) {
    const auto h = halfedge(e, mesh);
    const bool is_border = !CGAL::is_border(e, mesh) &&
                           get(segment_map, face(h, mesh)) !=
                             get(segment_map, face(opposite(h, mesh), mesh));
    put(edge_is_border_map, e, Value(is_border));
    count += is_border;
  }
  return count;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_SEGMENT_BORDERS_H
