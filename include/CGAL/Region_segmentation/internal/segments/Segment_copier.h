// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_COPIER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_COPIER_H

#include <CGAL/Region_segmentation/internal/segments/Halfedge_values.h>
#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>

#include <CGAL/Region_segmentation/internal/support/satisfies.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Mesh types in which the halfedge of a vertex leaves it, and is on the border if the vertex is (OpenMesh).
template <typename Mesh>
using Has_outgoing_halfedge = decltype(std::declval<Mesh&>().adjust_outgoing_halfedge(
  std::declval<typename boost::graph_traits<Mesh>::vertex_descriptor>()));

/// Copies segments to meshes of their own, one after another: halfedges first, with their faces; then a vertex for each
/// fan of faces. The only array of the size of the whole mesh is made once.
///
/// \tparam Target a model of `MutableFaceGraph`
template <typename Target, typename FaceGraph, typename Pack>
class Segment_copier
{
  using Traits = boost::graph_traits<FaceGraph>;
  using Target_traits = boost::graph_traits<Target>;
  using Target_halfedge = typename Target_traits::halfedge_descriptor;
  using Traversal = Mesh_traversal<FaceGraph, Pack>;

public:
  using face_descriptor = typename Traits::face_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using vertex_descriptor = typename Traits::vertex_descriptor;

  Segment_copier(const Segmented_mesh<Traversal>& segmented, const Pack& np)
    : m_segmented(segmented)
    , m_copies(segmented.mesh(), np, Copy())
    , m_point_map(CGAL::parameters::choose_parameter(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
        get_const_property_map(CGAL::vertex_point, segmented.mesh())))
  {}

  /// `faces`: those of one segment, which was not copied before. Returns the vertices of the input by the vertices of `piece`.
  template <typename FaceRange>
  std::vector<vertex_descriptor> copy(const FaceRange& faces_of_segment, Target& piece)
  {
    reserve_elements(faces_of_segment, piece);
    for (face_descriptor f : faces_of_segment)
      copy_face(f, piece);
    std::vector<vertex_descriptor> vertices;
    for (face_descriptor f : faces_of_segment)
      for (halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, mesh()), mesh()))
        if (!m_copies[h].has_target)
          copy_fan(h, piece, vertices);
    return vertices;
  }

private:
  struct Copy
  {
    Target_halfedge halfedge = Target_traits::null_halfedge();
    bool has_target = false;
  };

  const FaceGraph& mesh() const { return m_segmented.mesh(); }

  template <typename FaceRange>
  void reserve_elements(const FaceRange& faces_of_segment, Target& piece) const
  {
    std::size_t halfedges = 0, borders = 0;
    for (face_descriptor f : faces_of_segment)
      for (halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, mesh()), mesh())) {
        ++halfedges;
        borders += m_segmented.is_border(h);
      }
    const std::size_t number_of_edges = (halfedges + borders) / 2, number_of_faces = faces_of_segment.size();
    const std::size_t number_of_vertices = number_of_edges - number_of_faces + 1; // of a disc
    reserve(piece, typename Target_traits::vertices_size_type(number_of_vertices),
            typename Target_traits::edges_size_type(number_of_edges),
            typename Target_traits::faces_size_type(number_of_faces));
  }

  void copy_face(face_descriptor f, Target& piece)
  {
    const auto copy_of_f = add_face(piece);
    const halfedge_descriptor start = halfedge(f, mesh());
    const Target_halfedge first = copy_halfedge(start, piece);
    set_halfedge(copy_of_f, first, piece);
    Target_halfedge previous = first;
    set_face(first, copy_of_f, piece);
    for (halfedge_descriptor h = next(start, mesh()); h != start; h = next(h, mesh())) {
      const Target_halfedge copy = copy_halfedge(h, piece);
      set_face(copy, copy_of_f, piece);
      set_next(previous, copy, piece);
      previous = copy;
    }
    set_next(previous, first, piece);
  }

  Target_halfedge copy_halfedge(halfedge_descriptor h, Target& piece)
  {
    Copy& copy = m_copies[h];
    if (copy.halfedge != Target_traits::null_halfedge())
      return copy.halfedge; // made with its opposite
    copy.halfedge = halfedge(add_edge(piece), piece);
    if (m_segmented.is_border(h))
      set_face(opposite(copy.halfedge, piece), Target_traits::null_face(), piece);
    else
      m_copies[opposite(h, mesh())].halfedge = opposite(copy.halfedge, piece);
    return copy.halfedge;
  }

  /// Adds the vertex of the fan in which the target of `h` is a corner, and links the border around it.
  void copy_fan(halfedge_descriptor h, Target& piece, std::vector<vertex_descriptor>& vertices)
  {
    const auto v = add_vertex(piece);
    const vertex_descriptor original = target(h, mesh());
    vertices.push_back(original);
    copy_point(original, v, piece);

    // Clockwise to the face whose outgoing halfedge is on the border, or around.
    halfedge_descriptor last = h;
    do {
      attach(last, v, piece);
      const halfedge_descriptor out = next(last, mesh());
      if (m_segmented.is_border(out)) {
        copy_open_fan(h, out, v, piece);
        return;
      }
      last = opposite(out, mesh());
    } while (last != h);
    set_halfedge(v, m_copies[h].halfedge, piece);
  }

  /// Counterclockwise from `h` to the face whose incoming halfedge is on the border, like `out`.
  void copy_open_fan(halfedge_descriptor h, halfedge_descriptor out, typename Target_traits::vertex_descriptor v,
                     Target& piece)
  {
    while (!m_segmented.is_border(h)) {
      h = prev(opposite(h, mesh()), mesh());
      attach(h, v, piece);
    }
    const Target_halfedge arriving = opposite(m_copies[out].halfedge, piece),
                          leaving = opposite(m_copies[h].halfedge, piece);
    set_target(arriving, v, piece);
    set_next(arriving, leaving, piece);
    set_halfedge(v, arriving, piece);
    if constexpr (satisfies<Has_outgoing_halfedge, Target>)
      piece.adjust_outgoing_halfedge(v);
  }

  void attach(halfedge_descriptor h, typename Target_traits::vertex_descriptor v, Target& piece)
  {
    Copy& copy = m_copies[h];
    copy.has_target = true;
    set_target(copy.halfedge, v, piece);
  }

  void copy_point(vertex_descriptor from, typename Target_traits::vertex_descriptor to, Target& piece) const
  {
    const auto map = get(CGAL::vertex_point, piece);
    using Point = typename boost::property_traits<std::decay_t<decltype(map)>>::value_type;
    const auto& p = get(m_point_map, from);
    if constexpr (std::is_convertible<decltype(p), Point>::value)
      put(map, to, p);
    else {
      using Number = std::decay_t<decltype(std::declval<Point>()[0])>;
      put(map, to, Point(Number(CGAL::to_double(p[0])), Number(CGAL::to_double(p[1])), Number(CGAL::to_double(p[2]))));
    }
  }

  const Segmented_mesh<Traversal>& m_segmented;
  Halfedge_values<FaceGraph, Pack, Copy> m_copies;
  typename GetVertexPointMap<FaceGraph, Pack>::const_type m_point_map;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_COPIER_H
