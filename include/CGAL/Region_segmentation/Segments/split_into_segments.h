// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_SPLIT_INTO_SEGMENTS_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_SPLIT_INTO_SEGMENTS_H

#include <CGAL/Region_segmentation/Segments/internal/Segmented_mesh.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Support/internal/concept_checks.h>
#include <CGAL/Region_segmentation/Support/parameters.h>

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

namespace internal {

/// The piece of a segment; `SegmentMesh` is `void` for the type of the mesh itself.
template <typename SegmentMesh, typename FaceGraph, typename SegmentMap>
using Piece_of = Segment_piece<
  std::conditional_t<std::is_void<SegmentMesh>::value, FaceGraph, SegmentMesh>, FaceGraph,
  typename boost::property_traits<SegmentMap>::value_type>;

/// Mesh types in which the halfedge of a vertex leaves it, and is on the border if the vertex is
/// (OpenMesh).
template <typename Mesh>
using Has_outgoing_halfedge = decltype(std::declval<Mesh&>().adjust_outgoing_halfedge(
  std::declval<typename boost::graph_traits<Mesh>::vertex_descriptor>()));

/// Builds a mesh of each segment, one after another, with a vertex for each fan of its faces.
template <typename Piece, typename Mesh>
class Piece_builder
{
  using Index = Segmented_halfedges::Index;
  using Target = decltype(Piece::mesh);
  using Traits = boost::graph_traits<Target>;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Vertex = typename Traits::vertex_descriptor;

public:
  /// `mesh`: a `Segmented_mesh`, whose descriptors the pieces have
  /// `pieces`: the halfedges to be copied: those of `mesh`, or these with more faces
  Piece_builder(const Mesh& mesh, const Segmented_halfedges& pieces)
    : m_mesh(mesh)
    , m_pieces(pieces)
    , m_fans(pieces.fans())
    , m_halfedges(pieces.number_of_segments,
                  [&](const auto& add) {
                    for (Index h = 0; h < pieces.size(); ++h)
                      if (pieces.has_segment(h))
                        add(pieces.segment(h), h);
                  })
    , m_copies(pieces.size(), Traits::null_halfedge())
    , m_vertices(m_fans.number_of_parts(), Traits::null_vertex())
  {}

  /// Outputs the pieces of all segments; called once.
  /// `with_point(h, fan, f)`: calls `f(point)` for the source of a halfedge in a fan of faces
  template <typename OutputIterator, typename WithPoint>
  OutputIterator build(OutputIterator output, const WithPoint& with_point)
  {
    for (std::size_t s = 0; s < m_pieces.number_of_segments; ++s)
      *output++ = build_piece(s, with_point);
    return output;
  }

private:
  template <typename WithPoint>
  Piece build_piece(std::size_t segment, const WithPoint& with_point)
  {
    Piece piece;
    piece.segment = m_mesh.labels[segment];
    add_vertices_and_edges(segment, piece, with_point);
    auto copied_face = Traits::null_face();
    for (const Index h : m_halfedges[segment]) {
      if (const Index f = m_pieces.face[h]; h == m_pieces.first[f]) {
        copied_face = add_face(piece.mesh);
        set_halfedge(copied_face, m_copies[h], piece.mesh);
        piece.faces.push_back(m_mesh.face_at(f));
      }
      const Index next = m_pieces.next(h);
      link(m_copies[h], m_copies[next], next, copied_face, piece.mesh);
    }
    for (const Index h : m_halfedges[segment])
      if (m_pieces.is_on_border(h)) {
        const Index next = m_pieces.next_on_border(h);
        link(opposite(m_copies[next], piece.mesh), opposite(m_copies[h], piece.mesh), next,
             Traits::null_face(), piece.mesh);
      }
    if constexpr (satisfies<Has_outgoing_halfedge, Target>)
      for (Vertex v : vertices(piece.mesh))
        piece.mesh.adjust_outgoing_halfedge(v);
    return piece;
  }

  template <typename WithPoint>
  void add_vertices_and_edges(std::size_t segment, Piece& piece, const WithPoint& with_point)
  {
    for (const Index h : m_halfedges[segment]) {
      if (Vertex& v = m_vertices[m_fans[h]]; v == Traits::null_vertex()) {
        v = add_vertex(piece.mesh);
        piece.vertices.push_back(m_mesh.vertex_at(m_pieces.source[h]));
        with_point(h, m_fans[h], [&](const auto& p) { put_point(p, v, piece.mesh); });
      }
      if (m_copies[h] != Traits::null_halfedge())
        continue; // the edge was made with the opposite halfedge
      m_copies[h] = halfedge(add_edge(piece.mesh), piece.mesh);
      if (!m_pieces.is_on_border(h))
        m_copies[m_pieces.opposite[h]] = opposite(m_copies[h], piece.mesh);
    }
  }

  /// Links a halfedge to the next one of a face or border, and to the vertex between them, which
  /// `leaving` leaves.
  void link(Halfedge h, Halfedge next, Index leaving, typename Traits::face_descriptor face,
            Target& target) const
  {
    const Vertex v = m_vertices[m_fans[leaving]];
    set_face(h, face, target);
    set_next(h, next, target);
    set_target(h, v, target);
    set_halfedge(v, h, target);
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

  const Mesh& m_mesh;
  const Segmented_halfedges& m_pieces;
  const Partition m_fans;
  const Grouped_items<Index> m_halfedges; // by segment
  std::vector<Halfedge> m_copies;         // by halfedge
  std::vector<Vertex> m_vertices;         // by fan
};

} // namespace internal

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
///     \cgalParamDescription{edges inside segments along which the copies are cut open, such as
///       those that make a disc of a segment}
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
/// \returns the output iterator
///
/// Complexity: O(F + V) for all segments together. Read-only; concurrent calls are safe.
template <typename SegmentMesh = void, typename FaceGraph, typename FaceSegmentMap,
          typename PieceOutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
PieceOutputIterator split_into_segments(const FaceGraph& mesh, const FaceSegmentMap& segment_map,
                                        PieceOutputIterator pieces,
                                        const NamedParameters& np = parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Piece = internal::Piece_of<SegmentMesh, FaceGraph, FaceSegmentMap>;
  const auto& pack = internal::pack(np);
  using Pack = std::decay_t<decltype(pack)>;
  internal::check_parameters<Pack, internal::Tag_list<CGAL::internal_np::edge_is_constrained_t>>();
  auto segmented = internal::read_segmented_mesh(mesh, segment_map, pack);
  if constexpr (internal::has_parameter<Pack, CGAL::internal_np::edge_is_constrained_t>) {
    const auto is_cut = get_parameter(pack, CGAL::internal_np::edge_is_constrained);
    for (std::uint32_t h = 0; h < segmented.size(); ++h)
      if (get(is_cut, edge(segmented.halfedges[h], mesh)))
        segmented.opposite[h] = segmented.none;
  }
  const auto points = choose_parameter(get_parameter(pack, CGAL::internal_np::vertex_point),
                                       get_const_property_map(CGAL::vertex_point, mesh));
  return internal::Piece_builder<Piece, decltype(segmented)>(segmented, segmented)
    .build(pieces, [&](std::uint32_t h, std::uint32_t, const auto& f) {
      f(get(points, segmented.vertices[segmented.source[h]]));
    });
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_SPLIT_INTO_SEGMENTS_H
