// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_COMPUTE_SEGMENT_TOPOLOGY_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_COMPUTE_SEGMENT_TOPOLOGY_H

#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>
#include <CGAL/Region_segmentation/internal/segments/topology.h>
#include <CGAL/Region_segmentation/internal/support/check_output.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationSegments
/// The topology of a segment. Where it touches itself at a vertex, it has several vertices, one for each fan of its faces, as
/// in `split_into_segments()`.
template <typename Label>
struct Segment_topology
{
  Label segment;
  std::size_t number_of_components;    ///< connected across edges
  std::size_t number_of_border_loops;  ///< to other segments, to faces without a segment, and of the mesh
  std::ptrdiff_t euler_characteristic; ///< vertices - edges + faces

  bool is_disc() const { return number_of_components == 1 && number_of_border_loops == 1 && euler_characteristic == 1; }
  /// The sum of the genera of the components: (2 c - b - x) / 2 for c components, b loops and the characteristic x.
  std::size_t genus() const
  {
    return std::size_t(2 * std::ptrdiff_t(number_of_components) - std::ptrdiff_t(number_of_border_loops) -
                       euler_characteristic) / 2;
  }
};

/// \ingroup PkgRegionSegmentationSegments
/// computes the Euler characteristic, the number of border loops and the number of components of every segment.
///
/// \tparam FaceGraph a model of `FaceListGraph`, `VertexListGraph` and `HalfedgeListGraph`
/// \tparam FaceSegmentMap a model of `ReadablePropertyMap` with the face descriptor as key and an integral value type of
///         at most 64 bits
/// \tparam TopologyOutputIterator a model of `OutputIterator` that takes `Segment_topology<Label>`, `Label` the value type
///         of `FaceSegmentMap`
/// \param mesh an oriented 2-manifold with or without boundary, its faces polygons of any size
/// \param segment_map the segments, by any labels; faces with the label `no_segment` belong to none
/// \param topologies receives the results, in the order of the first faces of the segments
/// \param np an optional sequence of \ref PkgRegionSegmentationNP "Named Parameters":
///
/// \cgalNamedParamsBegin
///   \cgalParamIndexMap{face}
///   \cgalParamIndexMap{vertex}
///   \cgalParamIndexMap{halfedge}
/// \cgalNamedParamsEnd
///
/// \returns the number of segments
///
/// Complexity: O(F + V) in practice. Read-only; concurrent calls are safe.
template <typename FaceGraph, typename FaceSegmentMap, typename TopologyOutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t compute_segment_topology(const FaceGraph& mesh, const FaceSegmentMap& segment_map,
                                     TopologyOutputIterator topologies,
                                     const NamedParameters& np = parameters::default_values())
{
  using Label = typename boost::property_traits<FaceSegmentMap>::value_type;
  static_assert(internal::check_output_of_labels<TopologyOutputIterator, Segment_topology<Label>>());
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Tag_list<>>();
  const auto traversal = internal::make_mesh_traversal(mesh, pack);
  const auto numbers = internal::number_segments(traversal, segment_map);
  const internal::Segmented_mesh segmented(traversal, numbers.of_face);
  const auto counts = internal::count_surfaces(segmented, pack, numbers.labels.size());
  for (std::size_t s = 0; s < counts.size(); ++s)
    *topologies++ = Segment_topology<Label>{numbers.labels[s], counts[s].components, counts[s].loops,
                                            counts[s].euler_characteristic()};
  return counts.size();
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_COMPUTE_SEGMENT_TOPOLOGY_H
