// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_MESH_WALK_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_MESH_WALK_H

#include <CGAL/Region_segmentation/internal/Flat_mesh.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The position of a descriptor in its range, found by way of an index map of any numbering.
/// Takes 4 bytes an element where the index is not the position itself, and nothing else.
template <typename IndexMap>
class Iteration_ranks
{
public:
  using Descriptor = typename boost::property_traits<IndexMap>::key_type;

  /// `capacity`: an upper bound of the indices, removed elements of the mesh included.
  template <typename Range>
  Iteration_ranks(IndexMap index_map, const Range& range, std::size_t capacity)
    : m_index_map(index_map)
  {
    bool is_identity = true;
    for (const auto& d : range)
      is_identity = (std::size_t(get(m_index_map, d)) == m_size++) && is_identity;
    CGAL_precondition_msg(m_size < (std::numeric_limits<Flat_mesh::Index>::max)(),
                          "a mesh has fewer than 2^32 - 1 vertices, faces and edges");
    if (is_identity)
      return;
    m_ranks.resize(capacity);
    Flat_mesh::Index rank = 0;
    for (const auto& d : range) {
      const std::size_t index = get(m_index_map, d);
      CGAL_precondition_msg(index < capacity, "an index map has values from 0 to the size - 1");
      m_ranks[index] = rank++;
    }
  }

  std::size_t size() const { return m_size; }

  std::size_t operator[](const Descriptor& d) const
  {
    const std::size_t index = get(m_index_map, d);
    return m_ranks.empty() ? index : m_ranks[index];
  }

private:
  IndexMap m_index_map;
  std::size_t m_size = 0;
  std::vector<Flat_mesh::Index> m_ranks;
};

/// A face graph walked in an order that does not depend on its type: faces and vertices are numbered
/// by iteration, and the boundary of a face starts at its vertex of lowest number.
template <typename FaceGraph, typename Pack>
class Mesh_walk
{
  using Traits = boost::graph_traits<FaceGraph>;
  using Face_index_map = typename GetInitializedFaceIndexMap<FaceGraph, Pack>::const_type;
  using Vertex_index_map = typename GetInitializedVertexIndexMap<FaceGraph, Pack>::const_type;

public:
  using face_descriptor = typename Traits::face_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;

  /// The halfedges around a face; the first one leaves the vertex of lowest number.
  class Boundary
  {
  public:
    std::size_t size() const { return m_size; }
    halfedge_descriptor operator[](std::size_t i) const { return m_halfedges[m_first + i]; }

  private:
    friend class Mesh_walk;
    std::vector<halfedge_descriptor> m_halfedges; // the cycle twice: no element is moved to start
    std::size_t m_first = 0, m_size = 0;
  };

  Mesh_walk(const FaceGraph& mesh, const Pack& np)
    : m_mesh(mesh)
    , m_face_ranks(get_initialized_face_index_map(mesh, np), faces(mesh), num_faces(mesh))
    , m_vertex_ranks(get_initialized_vertex_index_map(mesh, np), vertices(mesh),
                     num_vertices(mesh))
  {}

  const FaceGraph& mesh() const { return m_mesh; }
  std::size_t number_of_faces() const { return m_face_ranks.size(); }
  std::size_t number_of_vertices() const { return m_vertex_ranks.size(); }

  std::size_t source_rank(halfedge_descriptor h) const { return m_vertex_ranks[source(h, m_mesh)]; }

  void read_boundary(face_descriptor f, Boundary& around) const
  {
    auto& halfedges = around.m_halfedges;
    halfedges.clear();
    std::size_t lowest = (std::numeric_limits<std::size_t>::max)();
    const halfedge_descriptor start = halfedge(f, m_mesh);
    halfedge_descriptor h = start;
    do {
      const std::size_t rank = source_rank(h);
      around.m_first = rank < lowest ? halfedges.size() : around.m_first;
      lowest = (std::min)(rank, lowest);
      halfedges.push_back(h);
      h = next(h, m_mesh);
    } while (h != start);
    around.m_size = halfedges.size();
    for (std::size_t i = 0; i + 1 < around.m_size; ++i)
      halfedges.push_back(halfedges[i]);
  }

  /// The number of the face on the other side of a halfedge; `no_face` at a border.
  std::size_t opposite_face_rank(halfedge_descriptor h) const
  {
    const face_descriptor f = face(opposite(h, m_mesh), m_mesh);
    return f == Traits::null_face() ? no_face : m_face_ranks[f];
  }
  static constexpr std::size_t no_face = (std::numeric_limits<std::size_t>::max)();

  /// Calls `f(halfedge, dual_edge)` for every dual edge of the flat mesh made by this walk, in the
  /// order in which it was made.
  template <typename F>
  void for_each_dual_edge(const Flat_mesh& flat, F f) const
  {
    // The dual edges of a lower face are met in their order: its higher faces come one after another.
    std::vector<Flat_mesh::Index> next_edges(flat.number_of_faces());
    for (std::size_t i = 0; i < next_edges.size(); ++i)
      next_edges[i] = Flat_mesh::Index(flat.first_edge(i));
    Boundary around;
    std::size_t rank = 0;
    for (face_descriptor fd : faces(m_mesh)) {
      read_boundary(fd, around);
      for (std::size_t i = 0; i < around.size(); ++i)
        if (const std::size_t lower = opposite_face_rank(around[i]); lower < rank)
          f(around[i], next_edges[lower]++);
      ++rank;
    }
  }

private:
  const FaceGraph& m_mesh;
  Iteration_ranks<Face_index_map> m_face_ranks;
  Iteration_ranks<Vertex_index_map> m_vertex_ranks;
};

template <typename FaceGraph, typename Pack>
Mesh_walk<FaceGraph, Pack> make_mesh_walk(const FaceGraph& mesh, const Pack& np)
{
  return Mesh_walk<FaceGraph, Pack>(mesh, np);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_MESH_WALK_H
