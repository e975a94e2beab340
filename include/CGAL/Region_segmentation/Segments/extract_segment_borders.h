// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_EXTRACT_SEGMENT_BORDERS_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_EXTRACT_SEGMENT_BORDERS_H

#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The edges between segments, joined to chains. An edge is represented by its halfedge in the
/// segment of lower number (`none` is above all), so that the chains between two segments run in
/// one direction.
class Border_chains
{
  using Index = Halfedge_table::Index;
  static constexpr Index none = Halfedge_table::none;

public:
  explicit Border_chains(const Segmented_halfedges& mesh)
    : m_mesh(mesh)
    , m_leaving(mesh.number_of_vertices, Index(none))
    , m_is_junction(mesh.number_of_vertices, false)
  {
    std::vector<Index> arriving(mesh.number_of_vertices, Index(none));
    const auto add = [&](Index& place, Index h, Index vertex) {
      m_is_junction[vertex] |= place != none; // a second one
      place = h;
    };
    for (Index h = 0; h < mesh.size(); ++h)
      if (mesh.opposite[h] == none)
        m_is_junction[mesh.source[h]] = m_is_junction[mesh.target(h)] = true;
      else if (mesh.segment(h) < mesh.segment_across(h)) {
        m_halfedges.push_back(h);
        add(m_leaving[mesh.source[h]], h, mesh.source[h]);
        add(arriving[mesh.target(h)], h, mesh.target(h));
      }
    // At any other vertex two edges separate the same two segments: one arrives, one leaves.
    for (std::size_t v = 0; v < mesh.number_of_vertices; ++v)
      m_is_junction[v] |= (m_leaving[v] == none) != (arriving[v] == none);
  }

  /// Calls `f(halfedges, is_closed)` for the open chains, then for the closed ones, each kind by
  /// its first faces.
  template <typename F>
  void for_each_chain(const F& f) const
  {
    std::vector<char> is_done(m_mesh.size(), false);
    for (Index h : m_halfedges)
      if (m_is_junction[m_mesh.source[h]])
        f(chain_from(h, is_done), false);
    for (Index h : m_halfedges)
      if (!is_done[h])
        f(chain_from(h, is_done), true);
  }

private:
  std::vector<Index> chain_from(Index h, std::vector<char>& is_done) const
  {
    std::vector<Index> chain;
    while (!is_done[h]) {
      is_done[h] = true;
      chain.push_back(h);
      if (m_is_junction[m_mesh.target(h)])
        break;
      h = m_leaving[m_mesh.target(h)];
    }
    return chain;
  }

  const Segmented_halfedges& m_mesh;
  std::vector<Index> m_halfedges;
  std::vector<Index> m_leaving;    // by vertex: a halfedge that leaves it
  std::vector<char> m_is_junction; // by vertex
};

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
/// \returns the number of polylines
///
/// Complexity: O(F log d), d the number of corners of a face. Deterministic: the same polylines
/// from every mesh type. Read-only; concurrent calls are safe.
template <typename FaceGraph, typename FaceSegmentMap, typename BorderOutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
std::size_t extract_segment_borders(const FaceGraph& mesh, const FaceSegmentMap& segment_map,
                                    BorderOutputIterator borders,
                                    const NamedParameters& np = parameters::default_values())
{
  using Label = typename boost::property_traits<FaceSegmentMap>::value_type;
  const auto& pack = internal::pack(np);
  internal::check_parameters<std::decay_t<decltype(pack)>, internal::Tag_list<>>();
  const internal::Segmented_mesh segmented(mesh, segment_map, pack);
  const internal::Border_chains chains(segmented);
  std::size_t count = 0;
  chains.for_each_chain([&](const auto& chain, bool is_closed) {
    Segment_border<FaceGraph, Label> border;
    border.segment = segmented.label(segmented.segment(chain.front()));
    border.opposite_segment = segmented.label(segmented.segment_across(chain.front()));
    for (auto h : chain)
      border.halfedges.push_back(segmented.descriptors[h]);
    border.is_closed = is_closed;
    *borders++ = std::move(border);
    ++count;
  });
  return count;
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_EXTRACT_SEGMENT_BORDERS_H
