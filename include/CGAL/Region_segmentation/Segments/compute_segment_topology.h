// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_COMPUTE_SEGMENT_TOPOLOGY_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_COMPUTE_SEGMENT_TOPOLOGY_H

#include <CGAL/Region_segmentation/Segments/internal/Segmented_mesh.h>
#include <CGAL/Region_segmentation/Support/parameters.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
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
  std::size_t number_of_components; ///< of faces that are connected by edges
  /// The closed polylines of edges to other segments, to faces without a segment, and on the border
  /// of the mesh.
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

/// The topology of each segment, with a vertex for each fan of its faces.
template <typename FaceGraph, typename Label>
std::vector<Segment_topology<Label>> topologies_of(const Segmented_mesh<FaceGraph, Label>& mesh)
{
  using Index = Segmented_halfedges::Index;
  std::vector<Segment_topology<Label>> result;
  for (const Label label : mesh.labels)
    result.push_back({label, 0, 0, 0});
  // Each union of two trees reduces the number of components, or of vertices, by one.
  Lowest_root_forest components(mesh.number_of_faces()), fans(mesh.size());
  std::vector<char> is_on_loop(mesh.size(), false);
  for (Index h = 0; h < mesh.size(); ++h) {
    if (!mesh.has_segment(h))
      continue;
    Segment_topology<Label>& topology = result[mesh.segment(h)];
    if (h == mesh.first[mesh.face[h]]) {
      ++topology.number_of_components;
      ++topology.euler_characteristic;
    }
    ++topology.euler_characteristic; // the vertex
    const Index across = mesh.opposite[h];
    if (!mesh.is_on_border(h)) {
      topology.number_of_components -= components.unite(mesh.face[h], mesh.face[across]);
      topology.euler_characteristic -= fans.unite(h, mesh.next(across)) + (h < across);
      continue;
    }
    --topology.euler_characteristic; // the edge
    topology.number_of_border_loops += !is_on_loop[h];
    for (Index i = h; !is_on_loop[i]; i = mesh.next_on_border(i))
      is_on_loop[i] = true;
  }
  return result;
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
/// \returns the output iterator
///
/// Complexity: O(F + V) in practice. Read-only; concurrent calls are safe.
template <typename FaceGraph, typename FaceSegmentMap, typename TopologyOutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
TopologyOutputIterator
compute_segment_topology(const FaceGraph& mesh, const FaceSegmentMap& segment_map,
                         TopologyOutputIterator topologies,
                         const NamedParameters& np = parameters::default_values())
{
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Tag_list<>>();
  const auto result = internal::topologies_of(
    internal::read_segmented_mesh(mesh, segment_map, pack));
  return std::copy(result.begin(), result.end(), topologies);
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_COMPUTE_SEGMENT_TOPOLOGY_H
