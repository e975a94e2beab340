// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_READ_FACE_GRAPH_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_READ_FACE_GRAPH_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/internal/support/arrays.h>
#include <CGAL/Region_segmentation/internal/surface/Raw_surface.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The elements of a range by position, and the position of each, found by an index map of any
/// numbering. Takes a descriptor per element, and 4 bytes unless the index is the position. (With
/// these always, a mesh in random order of 320,000 faces is read in twice the time.)
///
/// The descriptors are stored since the latencies of traversing a linked list add up, while those
/// of several handles overlap.
template <typename IndexMap, typename Descriptor>
class Iteration_ranks
{
public:
  /// `capacity`: an upper bound of the indices, removed elements of the mesh included.
  template <typename Range>
  Iteration_ranks(IndexMap index_map, const Range& range, std::size_t capacity)
    : m_index_map(index_map)
  {
    bool is_identity = true;
    m_elements.reserve(capacity);
    for (const Descriptor& d : range) {
      is_identity &= std::size_t(get(m_index_map, d)) == size();
      m_elements.push_back(d);
    }
    CGAL_precondition_msg(size() < (std::numeric_limits<Surface::Index>::max)(),
                          "a mesh has fewer than 2^32 - 1 vertices and faces");
    if (!is_identity)
      m_ranks.resize(capacity);
    for (std::size_t rank = 0; rank < size() && !is_identity; ++rank) {
      const std::size_t index = get(m_index_map, m_elements[rank]);
      CGAL_precondition_msg(index < capacity, "an index map has values from 0 to the size - 1");
      m_ranks[index] = Surface::Index(rank);
    }
  }

  std::size_t size() const { return m_elements.size(); }
  Surface::Index operator[](const Descriptor& d) const
  {
    const std::size_t index = get(m_index_map, d);
    return m_ranks.empty() ? Surface::Index(index) : m_ranks[index];
  }
  const std::vector<Descriptor>& elements() const { return m_elements; }

private:
  IndexMap m_index_map;
  Large_array<Surface::Index> m_ranks; // by index; empty: the same
  std::vector<Descriptor> m_elements;
};

/// The order of the elements of a face graph, which does not depend on its type: faces and vertices
/// are numbered by iteration, and the boundary of a face begins at its vertex of lowest number.
template <typename FaceGraph, typename Pack>
class Mesh_order
{
  using Traits = boost::graph_traits<FaceGraph>;
  using Face_index_map = typename GetInitializedFaceIndexMap<FaceGraph, Pack>::const_type;
  using Vertex_index_map = typename GetInitializedVertexIndexMap<FaceGraph, Pack>::const_type;

public:
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using face_descriptor = typename Traits::face_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;

  static constexpr Surface::Index none = (std::numeric_limits<Surface::Index>::max)();

  /// \throws Invalid_input if there are too many halfedges
  Mesh_order(const FaceGraph& mesh, const Pack& np)
    : m_mesh(mesh)
    , m_faces(get_initialized_face_index_map(mesh, np), faces(mesh), num_faces(mesh))
    , m_vertices(get_initialized_vertex_index_map(mesh, np), vertices(mesh), num_vertices(mesh))
  {
    if (num_halfedges(mesh) >= none) // corners are counted in 32 bits
      throw Invalid_input("a mesh has fewer than 2^32 - 1 halfedges");
  }

  const FaceGraph& mesh() const { return m_mesh; }
  std::size_t number_of_faces() const { return m_faces.size(); }
  std::size_t number_of_vertices() const { return m_vertices.size(); }

  Surface::Index vertex_rank(vertex_descriptor v) const { return m_vertices[v]; }
  /// The number of the face of a halfedge; `none` at a border.
  Surface::Index face_rank(halfedge_descriptor h) const
  {
    const face_descriptor f = face(h, m_mesh);
    return f == Traits::null_face() ? none : m_faces[f];
  }

  /// The halfedge of a face that leaves its vertex of lowest number.
  halfedge_descriptor first_halfedge(face_descriptor f) const
  {
    halfedge_descriptor first = halfedge(f, m_mesh);
    Surface::Index lowest = none;
    for (halfedge_descriptor h : CGAL::halfedges_around_face(first, m_mesh))
      if (const Surface::Index rank = vertex_rank(source(h, m_mesh)); rank < lowest) {
        lowest = rank;
        first = h;
      }
    return first;
  }

  const auto& ordered_faces() const { return m_faces.elements(); }
  const auto& ordered_vertices() const { return m_vertices.elements(); }

private:
  const FaceGraph& m_mesh;
  Iteration_ranks<Face_index_map, face_descriptor> m_faces;
  Iteration_ranks<Vertex_index_map, vertex_descriptor> m_vertices;
};

/// The points of the vertices. A vertex point map may return points by value.
template <typename FaceGraph, typename Pack>
void read_points(const Mesh_order<FaceGraph, Pack>& order, const Pack& np, Surface_arrays& arrays,
                 const Execution& execution)
{
  const auto point_map = CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_point),
    get_const_property_map(vertex_point, order.mesh()));
  arrays.points.resize(order.number_of_vertices());
  for_each_block(execution, order.number_of_vertices(),
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) {
                     const auto v = order.ordered_vertices()[i];
                     const auto& p = get(point_map, v);
                     Double_3& q = arrays.points[i];
                     q = {CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])};
                   }
                 });
}

/// The corners of the faces, and the faces across their sides.
template <typename FaceGraph, typename Pack>
void read_corners(const Mesh_order<FaceGraph, Pack>& order, Raw_surface& raw,
                  const Execution& execution)
{
  const FaceGraph& mesh = order.mesh();
  Surface_arrays& arrays = arrays_of(raw.surface);
  arrays.first_corners.resize(order.number_of_faces() + 1);
  arrays.corners.resize(num_halfedges(mesh));
  raw.neighbors.resize(num_halfedges(mesh));
  const auto halfedges_of = [&](std::size_t face) {
    return CGAL::halfedges_around_face(halfedge(order.ordered_faces()[face], mesh), mesh);
  };
  const std::size_t number = for_each_block_of_output(
    execution, order.number_of_faces(),
    [&](std::size_t, std::size_t begin, std::size_t end) {
      std::size_t result = 0;
      for (std::size_t f = begin; f < end; ++f)
        result += halfedges_of(f).size();
      return result;
    },
    [&](std::size_t, std::size_t begin, std::size_t end, std::size_t corner) {
      for (std::size_t f = begin; f < end; ++f) {
        arrays.first_corners[f] = Surface::Index(corner);
        for (auto h : halfedges_of(f)) {
          arrays.corners[corner] = order.vertex_rank(source(h, mesh));
          raw.neighbors[corner++] = order.face_rank(opposite(h, mesh));
        }
      }
      return corner;
    });
  arrays.first_corners.back() = Surface::Index(number);
  arrays.corners.resize(number);
  raw.neighbors.resize(number);
  // Not face by face above: what is unpredictable waits for memory there.
  begin_at_lowest_vertices(raw, execution);
}

template <typename FaceGraph, typename Pack>
Raw_surface read_face_graph(const Mesh_order<FaceGraph, Pack>& order, const Pack& np,
                            const Execution& execution)
{
  Raw_surface raw;
  read_points(order, np, arrays_of(raw.surface), execution.step(0, 0.3));
  read_corners(order, raw, execution.step(0.3, 1));
  set_unit(raw.surface);
  return raw;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_READ_FACE_GRAPH_H
