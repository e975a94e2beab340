// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_COMPUTE_SEGMENT_TOPOLOGY_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_COMPUTE_SEGMENT_TOPOLOGY_H

#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationSegments
/// The topology of a segment. Where it touches itself at a vertex, it has several vertices, one for
/// each fan of its faces, as in `split_into_segments()`.
template <typename Label>
struct Segment_topology
{
  Label segment;
  std::size_t number_of_components; ///< connected across edges
  /// To other segments, to faces without a segment, and of the mesh.
  std::size_t number_of_border_loops;
  std::ptrdiff_t euler_characteristic; ///< vertices - edges + faces

  bool is_disc() const
  {
    return number_of_components == 1 && number_of_border_loops == 1 && euler_characteristic == 1;
  }
  /// The sum of the genera of the components: (2 c - b - x) / 2 for c components, b loops and the
  /// characteristic x.
  std::size_t genus() const
  {
    const auto c = std::ptrdiff_t(number_of_components), b = std::ptrdiff_t(number_of_border_loops);
    return std::size_t(2 * c - b - euler_characteristic) / 2;
  }
};

namespace internal {

/// The numbers of elements of a segment, with a vertex for each fan of its faces.
struct Topology_counts
{
  std::size_t faces = 0, halfedges = 0, border_halfedges = 0, vertices = 0, components = 0,
              loops = 0;
};

/// Of each segment. The halfedges on its border meet in fans: a loop is a component of them.
inline std::vector<Topology_counts> count_topology(const Segmented_halfedges& mesh)
{
  using Index = Halfedge_table::Index;
  std::vector<Topology_counts> counts(mesh.number_of_segments);
  const Partition fans = mesh.fans();
  Lowest_root_forest components(mesh.number_of_faces()), loops(fans.number_of_parts());
  std::vector<char> is_on_loop(fans.number_of_parts(), false);
  const auto for_each_halfedge = [&](const auto& f) {
    for (Index h = 0; h < mesh.size(); ++h)
      if (mesh.segment(h) != mesh.none)
        f(h, counts[mesh.segment(h)]);
  };
  for_each_halfedge([&](Index h, Topology_counts& of_segment) {
    ++of_segment.halfedges;
    if (!mesh.is_on_border(h))
      components.unite(mesh.face[h], mesh.face[mesh.opposite[h]]);
    else {
      ++of_segment.border_halfedges;
      is_on_loop[fans[h]] = true;
      loops.unite(fans[h], fans[mesh.next(h)]);
    }
  });
  Index next_fan = 0; // numbered by their first halfedges
  for_each_halfedge([&](Index h, Topology_counts& of_segment) {
    if (h == mesh.first[mesh.face[h]]) {
      ++of_segment.faces;
      of_segment.components += components.root(mesh.face[h]) == mesh.face[h];
    }
    if (fans[h] >= next_fan) {
      next_fan = fans[h] + 1;
      ++of_segment.vertices;
      of_segment.loops += is_on_loop[fans[h]] && loops.root(fans[h]) == fans[h];
    }
  });
  return counts;
}

} // namespace internal

/// \ingroup PkgRegionSegmentationSegments
/// computes the Euler characteristic, the number of border loops and the number of components of
/// every segment.
///
/// \tparam FaceGraph a model of `FaceListGraph`, `HalfedgeListGraph` and `VertexListGraph`
/// \tparam FaceSegmentMap a model of `ReadablePropertyMap` with the face descriptor as key and an
///         integral value type of at most 64 bits
/// \tparam TopologyOutputIterator a model of `OutputIterator` that takes `Segment_topology<Label>`,
///         `Label` the value type of `FaceSegmentMap`
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
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Tag_list<>>();
  const internal::Segmented_mesh segmented(mesh, segment_map, pack);
  const auto counts = internal::count_topology(segmented);
  for (std::size_t s = 0; s < counts.size(); ++s) {
    const auto& c = counts[s];
    const std::size_t edges = (c.halfedges + c.border_halfedges) / 2;
    *topologies++ = Segment_topology<Label>{segmented.labels[s], c.components, c.loops,
                                            std::ptrdiff_t(c.vertices + c.faces) -
                                              std::ptrdiff_t(edges)};
  }
  return counts.size();
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_COMPUTE_SEGMENT_TOPOLOGY_H
