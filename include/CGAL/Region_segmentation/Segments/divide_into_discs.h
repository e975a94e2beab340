// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_DIVIDE_INTO_DISCS_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_DIVIDE_INTO_DISCS_H

#include <CGAL/Region_segmentation/Segments/Seam_cost.h>
#include <CGAL/Region_segmentation/Segments/no_segment.h>
#include <CGAL/Region_segmentation/internal/segments/Disc_divider.h>
#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>
#include <CGAL/Region_segmentation/parameters.h>
#include <CGAL/Region_segmentation/read_flat_mesh.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationSegments
/// divides segments into discs: connected, with one border loop and Euler characteristic 1, as parameterizations need
/// them.
///
/// A segment that is a disc stays as it is. Components become segments of their own. A component that is not a disc is opened
/// along the seams of `mark_segment_seams()`, and divided into the faces nearer to one side of the seams and those nearer to
/// the other one (by the distance of centroids inside the opened disc); so a tube becomes two halves, and a sphere, too. In
/// rare cases the halves are divided again.
///
/// \tparam FaceGraph a model of `FaceListGraph`, `VertexListGraph` and `HalfedgeListGraph`
/// \tparam FaceSegmentMap a model of `ReadablePropertyMap` with the face descriptor as key and an integral value type of
///         at most 64 bits
/// \tparam FaceDiscMap a model of `WritablePropertyMap` with the face descriptor as key and an integral value type that
///         holds the number of discs
/// \param mesh an oriented 2-manifold with or without boundary, its faces polygons of any size
/// \param segment_map the segments, by any labels; faces with the label `no_segment` belong to none
/// \param disc_map every key is written: ids 0 .. n-1, numbered by the first face; `no_segment` for the faces without a
///        segment. Can be the same map
/// \param cost the cost of seams
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamVertexPointMap
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
///   \cgalParamIndexMap{halfedge}
/// \cgalNamedParamsEnd
///
/// \returns the number n of discs
/// \post every disc lies in one segment
/// \throws Invalid_input if a point is not finite; the map is unchanged
/// \pre `cost.concave_gain >= 0`
///
/// Complexity: O(F log F) for each round of dividing, of which there is one, rarely two. Deterministic: the same discs from
/// every mesh type. Concurrent calls on different maps are safe.
template <typename FaceGraph, typename FaceSegmentMap, typename FaceDiscMap,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t divide_into_discs(const FaceGraph& mesh, const FaceSegmentMap& segment_map, FaceDiscMap disc_map,
                              const Seam_cost& cost, const NamedParameters& np = parameters::default_values())
{
  using Label = typename boost::property_traits<FaceDiscMap>::value_type;
  CGAL_precondition(cost.concave_gain >= 0);
  const auto& pack = internal::pack(np);
  using Pack = std::decay_t<decltype(pack)>;
  internal::check_parameters<Pack, internal::Tag_list<>>();
  const auto traversal = internal::make_mesh_traversal(mesh, pack);
  const Flat_mesh flat = internal::read_flat_mesh<CGAL::Sequential_tag>(traversal, pack, Mesh_data::CENTROIDS);
  const auto numbers = internal::number_segments(traversal, segment_map);
  internal::Disc_divider<FaceGraph, Pack> divider(traversal, pack, flat, cost.concave_gain, numbers.of_face);
  const std::size_t number = divider.divide();
  std::size_t i = 0;
  traversal.for_each_face([&](const auto& f) {
    const auto disc = divider.disc_of_face()[i++];
    put(disc_map, f, disc == numbers.none ? no_segment<Label> : Label(disc));
  });
  return number;
}

/// \ingroup PkgRegionSegmentationSegments
/// As above, with the constants of `Seam_cost`.
template <typename FaceGraph, typename FaceSegmentMap, typename FaceDiscMap,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t divide_into_discs(const FaceGraph& mesh, const FaceSegmentMap& segment_map, FaceDiscMap disc_map,
                              const NamedParameters& np = parameters::default_values())
{
  return divide_into_discs(mesh, segment_map, disc_map, Seam_cost(), np);
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_DIVIDE_INTO_DISCS_H
