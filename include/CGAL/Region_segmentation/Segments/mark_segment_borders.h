// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_MARK_SEGMENT_BORDERS_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_MARK_SEGMENT_BORDERS_H

#include <CGAL/Region_segmentation/internal/support/concept_checks.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

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

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_MARK_SEGMENT_BORDERS_H
