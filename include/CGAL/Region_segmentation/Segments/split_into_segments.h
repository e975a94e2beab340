// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_SPLIT_INTO_SEGMENTS_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_SPLIT_INTO_SEGMENTS_H

#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>
#include <CGAL/Region_segmentation/internal/support/arrays.h>
#include <CGAL/Region_segmentation/internal/support/concept_checks.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Mesh types in which the halfedge of a vertex leaves it, and is on the border if the vertex is
/// (OpenMesh).
template <typename Mesh>
using Has_outgoing_halfedge = decltype(std::declval<Mesh&>().adjust_outgoing_halfedge(
  std::declval<typename boost::graph_traits<Mesh>::vertex_descriptor>()));

/// The vertices, faces and points that the halfedges and faces of a table come from.
template <typename FaceGraph, typename PointMap>
struct Elements_of_graph
{
  const FaceGraph& mesh;
  const std::vector<typename boost::graph_traits<FaceGraph>::halfedge_descriptor>& descriptors;
  const PointMap& points;

  /// The vertex that a halfedge leaves.
  auto vertex_of(Halfedge_table::Index h) const { return source(descriptors[h], mesh); }
  /// The face of a halfedge.
  auto face_of(Halfedge_table::Index h) const { return face(descriptors[h], mesh); }
  template <typename F>
  void with_point(Halfedge_table::Index h, const F& f) const
  {
    f(get(points, vertex_of(h)));
  }
};

/// Builds a mesh of each segment, one after another, with a vertex for each fan of its faces.
///
/// \tparam Target a model of `MutableFaceGraph`
template <typename Target>
class Piece_builder
{
  using Index = Halfedge_table::Index;
  using Target_traits = boost::graph_traits<Target>;
  using Halfedge = typename Target_traits::halfedge_descriptor;
  using Vertex = typename Target_traits::vertex_descriptor;

public:
  explicit Piece_builder(const Segmented_halfedges& segmented)
    : m_segmented(segmented)
    , m_fans(segmented.fans())
    , m_faces(segmented.faces_of_segments())
    , m_copies(segmented.size(), Target_traits::null_halfedge())
    , m_vertices(m_fans.number_of_parts())
    , m_has_vertex(m_fans.number_of_parts(), false)
    , m_arriving(m_fans.number_of_parts())
  {}

  /// Fills the mesh, the faces and the vertices of a piece, once for each segment.
  /// `elements`: as `Elements_of_graph`
  template <typename Elements, typename Piece>
  void build(std::size_t segment, const Elements& elements, Piece& piece)
  {
    reserve_elements(segment, piece.mesh);
    for_each_halfedge(segment, [&](Index h) {
      if (std::exchange(m_has_vertex[m_fans[h]], true))
        return;
      m_vertices[m_fans[h]] = add_vertex(piece.mesh);
      piece.vertices.push_back(elements.vertex_of(h));
      const Vertex v = m_vertices[m_fans[h]];
      elements.with_point(h, [&](const auto& p) { put_point(p, v, piece.mesh); });
    });
    for (Index f : m_faces[segment]) {
      piece.faces.push_back(elements.face_of(m_segmented.first[f]));
      copy_face(f, piece.mesh);
    }
    link_border(segment, piece.mesh);
  }

private:
  template <typename F>
  void for_each_halfedge(std::size_t segment, const F& f) const
  {
    for (Index face : m_faces[segment])
      for (Index h = m_segmented.first[face]; h < m_segmented.first[face + 1]; ++h)
        f(h);
  }

  void reserve_elements(std::size_t segment, Target& piece) const
  {
    std::size_t halfedges = 0;
    for_each_halfedge(segment,
                      [&](Index h) { halfedges += m_segmented.is_on_border(h) ? 2u : 1u; });
    const std::size_t number_of_edges = halfedges / 2, number_of_faces = m_faces[segment].size();
    const std::size_t number_of_vertices = number_of_edges - number_of_faces + 1; // of a disc
    reserve(piece, typename Target_traits::vertices_size_type(number_of_vertices),
            typename Target_traits::edges_size_type(number_of_edges),
            typename Target_traits::faces_size_type(number_of_faces));
  }

  void copy_face(Index f, Target& piece)
  {
    const auto copy = add_face(piece);
    for (Index h = m_segmented.first[f]; h < m_segmented.first[f + 1]; ++h) {
      if (m_copies[h] == Target_traits::null_halfedge()) { // otherwise made with its opposite
        m_copies[h] = halfedge(add_edge(piece), piece);
        if (m_segmented.is_on_border(h))
          set_face(opposite(m_copies[h], piece), Target_traits::null_face(), piece);
        else
          m_copies[m_segmented.opposite[h]] = opposite(m_copies[h], piece);
      }
      const Vertex v = m_vertices[m_fans[m_segmented.next(h)]];
      set_face(m_copies[h], copy, piece);
      set_target(m_copies[h], v, piece);
      set_halfedge(v, m_copies[h], piece);
    }
    for (Index h = m_segmented.first[f]; h < m_segmented.first[f + 1]; ++h)
      set_next(m_copies[h], m_copies[m_segmented.next(h)], piece);
    set_halfedge(copy, m_copies[m_segmented.first[f]], piece);
  }

  /// One halfedge on the border arrives at an open fan and one leaves it: their opposites in the
  /// piece follow each other.
  void link_border(std::size_t segment, Target& piece)
  {
    for_each_halfedge(segment, [&](Index h) {
      if (m_segmented.is_on_border(h))
        m_arriving[m_fans[m_segmented.next(h)]] = h;
    });
    for_each_halfedge(segment, [&](Index h) {
      if (!m_segmented.is_on_border(h))
        return;
      const Halfedge outside = opposite(m_copies[h], piece);
      const Vertex v = m_vertices[m_fans[h]];
      set_target(outside, v, piece);
      set_next(outside, opposite(m_copies[m_arriving[m_fans[h]]], piece), piece);
      set_halfedge(v, outside, piece);
    });
    if constexpr (satisfies<Has_outgoing_halfedge, Target>)
      for (Vertex v : vertices(piece))
        piece.adjust_outgoing_halfedge(v);
  }

  template <typename Point>
  static void put_point(const Point& p, Vertex v, Target& piece)
  {
    const auto map = get(CGAL::vertex_point, piece);
    using Copy = typename boost::property_traits<std::decay_t<decltype(map)>>::value_type;
    if constexpr (std::is_convertible<Point, Copy>::value)
      put(map, v, p);
    else {
      using Number = std::decay_t<decltype(std::declval<Copy>()[0])>;
      const auto number = [](const auto& x) { return Number(CGAL::to_double(x)); };
      put(map, v, Copy(number(p[0]), number(p[1]), number(p[2])));
    }
  }

  const Segmented_halfedges& m_segmented;
  const Partition m_fans;
  const Grouped_items<Index> m_faces; // by segment
  std::vector<Halfedge> m_copies;     // by halfedge
  std::vector<Vertex> m_vertices;     // by fan
  std::vector<char> m_has_vertex;     // by fan
  std::vector<Index> m_arriving;      // by open fan: the halfedge on the border
};

} // namespace internal

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
