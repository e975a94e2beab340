// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_MARK_SEGMENT_SEAMS_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_MARK_SEGMENT_SEAMS_H

#include <CGAL/Region_segmentation/Border_cost.h>
#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Segments/mark_segment_borders.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/segments/Seam_finder.h>
#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>
#include <CGAL/Region_segmentation/internal/segments/signed_deviation.h>
#include <CGAL/Region_segmentation/make_surface.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <CGAL/assertions.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationSegments
/// marks the borders between segments, and inside them the seams that open every component of a
/// segment to a disc: the map of seam edges of `CGAL::Seam_mesh`.
///
/// A component of genus \f$g\f$ with \f$b > 0\f$ border loops is opened along \f$2g + b - 1\f$
/// paths from border to border, a closed one of genus \f$g > 0\f$ along \f$2g\f$ loops through a
/// vertex, and a sphere along a path between two vertices far from each other. A disc has no seam.
/// Paths are those of a shortest path tree and its dual (tree-cotree decomposition): two shortest
/// paths from an edge to the border each.
///
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph`, `VertexListGraph` and
///         `EdgeListGraph`
/// \tparam FaceSegmentMap a model of `ReadablePropertyMap` with the face descriptor as key and an
///         integral value type of at most 64 bits
/// \tparam EdgeIsSeamMap a model of `WritablePropertyMap` with the edge descriptor as key and a
///         value type constructible from `bool`
/// \param mesh an oriented 2-manifold with or without boundary, its faces polygons of any size
/// \param segment_map the segments, by any labels; faces with the label `no_segment` are not opened
/// \param edge_is_seam_map every key is written. Edges on the border of the mesh are not marked
/// \param cost of the edges of a seam: so seams are short, and hidden in valleys of any depth; as
///        short as possible with a gain of 0
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
///   \cgalParamIndexMap{halfedge}
/// \cgalNamedParamsEnd
///
/// \returns the number of marked edges; more than `mark_segment_borders()` marks if a component of
///          a segment is not a disc
/// \throws Invalid_input if a point is not finite; the map is unchanged
/// \pre `cost.concave_gain >= 0 && cost.maximum_deviation >= 0`
///
/// Complexity: O(F log F). Deterministic: the same edges from every mesh type. Concurrent calls on
/// different maps are safe.
///
/// Source: \cgalCite{EW05}.
template <typename FaceGraph, typename FaceSegmentMap, typename EdgeIsSeamMap,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t mark_segment_seams(const FaceGraph& mesh, const FaceSegmentMap& segment_map,
                               EdgeIsSeamMap edge_is_seam_map,
                               const Border_cost& cost = Border_cost{10, CGAL_PI},
                               const NamedParameters& np = parameters::default_values())
{
  using Value = typename boost::property_traits<EdgeIsSeamMap>::value_type;
  CGAL_precondition(cost.concave_gain >= 0 && cost.maximum_deviation >= 0);
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Tag_list<>>();
  const internal::Segmented_mesh segmented(mesh, segment_map, pack);
  const Surface surface = internal::make_surface_of_neighbors(mesh, pack);
  internal::Seam_finder finder(segmented, [&](std::uint32_t h) {
    return cost(norm(internal::direction(segmented, surface, h)),
                (std::max)(0.0, -internal::signed_deviation(segmented, surface, h)));
  });
  const auto seams = finder.find();
  const std::size_t number_of_borders = mark_segment_borders(mesh, segment_map, edge_is_seam_map);
  for (auto h : seams)
    put(edge_is_seam_map, edge(segmented.descriptors[h], mesh), Value(true));
  return number_of_borders + seams.size();
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_MARK_SEGMENT_SEAMS_H
