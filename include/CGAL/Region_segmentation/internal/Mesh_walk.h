// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_MESH_WALK_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_MESH_WALK_H

#include <CGAL/Region_segmentation/internal/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/blocks.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/config.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The position of a descriptor in its range, found by way of an index map of any numbering, and the range
/// in blocks. Takes 4 bytes an element where the index is not the position itself, and hardly anything else.
template <typename IndexMap, typename Range>
class Iteration_ranks
{
  using Iterator = decltype(std::begin(std::declval<const Range&>()));

public:
  using Descriptor = typename boost::property_traits<IndexMap>::key_type;

  /// `capacity`: an upper bound of the indices, removed elements of the mesh included.
  Iteration_ranks(IndexMap index_map, const Range& range, std::size_t capacity)
    : m_index_map(index_map)
  {
    bool is_identity = true;
    for (Iterator it = std::begin(range); it != std::end(range); ++it) {
      if (m_size % block_size == 0)
        m_block_starts.push_back(it);
      is_identity = (std::size_t(get(m_index_map, *it)) == m_size++) && is_identity;
    }
    m_block_starts.push_back(std::end(range));
    CGAL_precondition_msg(m_size < (std::numeric_limits<Flat_mesh::Index>::max)(),
                          "a mesh has fewer than 2^32 - 1 vertices, faces and edges");
    m_is_identity = is_identity;
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
    return m_is_identity ? index : m_ranks[index];
  }

  /// The elements of a block.
  CGAL::Iterator_range<Iterator> block(std::size_t i) const
  {
    return {m_block_starts[i], m_block_starts[i + 1]};
  }

private:
  IndexMap m_index_map;
  std::size_t m_size = 0;
  bool m_is_identity;
  std::vector<Flat_mesh::Index> m_ranks;
  std::vector<Iterator> m_block_starts; // and the end
};

/// A face graph walked in an order that does not depend on its type: faces and vertices are numbered
/// by iteration, and the boundary of a face begins at its vertex of lowest number.
///
/// What is done for every face is done for triangles in registers and without branches that depend on the
/// numbering, since these cannot be predicted.
template <typename FaceGraph, typename Pack>
class Mesh_walk
{
  using Traits = boost::graph_traits<FaceGraph>;
  using Face_index_map = typename GetInitializedFaceIndexMap<FaceGraph, Pack>::const_type;
  using Vertex_index_map = typename GetInitializedVertexIndexMap<FaceGraph, Pack>::const_type;
  using Face_range = std::decay_t<decltype(faces(std::declval<const FaceGraph&>()))>;
  using Vertex_range = std::decay_t<decltype(vertices(std::declval<const FaceGraph&>()))>;

public:
  using face_descriptor = typename Traits::face_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;

  /// The halfedges around a face.
  using Triangle = std::array<halfedge_descriptor, 3>;
  using Polygon = std::vector<halfedge_descriptor>;

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  /// Memory that a walk keeps while it goes from face to face.
  class Scratch
  {
    friend class Mesh_walk;
    struct Neighbor
    {
      std::size_t face_rank, place;
      halfedge_descriptor halfedge;
    };
    Polygon polygon;
    std::size_t first = 0;
    std::vector<Neighbor> neighbors;
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

  std::size_t vertex_rank(typename Traits::vertex_descriptor v) const { return m_vertex_ranks[v]; }
  std::size_t source_rank(halfedge_descriptor h) const { return m_vertex_ranks[source(h, m_mesh)]; }
  std::size_t target_rank(halfedge_descriptor h) const { return m_vertex_ranks[target(h, m_mesh)]; }

  /// The number of the face on the other side of a halfedge; `none` at a border.
  std::size_t opposite_face_rank(halfedge_descriptor h) const
  {
    const face_descriptor f = face(opposite(h, m_mesh), m_mesh);
    return f == Traits::null_face() ? none : m_face_ranks[f];
  }

  /// The faces and vertices with the numbers of one block.
  auto faces_of_block(std::size_t block) const { return m_face_ranks.block(block); }
  auto vertices_of_block(std::size_t block) const { return m_vertex_ranks.block(block); }

  /// Calls `f(boundary, first)` with the halfedges around a face, a `Triangle` or a `Polygon`: the boundary begins at
  /// the position `first`, where a halfedge leaves the vertex of lowest number.
  template <typename F>
  BOOST_FORCEINLINE void with_boundary(face_descriptor face, Scratch& scratch, const F& f) const
  {
    const halfedge_descriptor a = halfedge(face, m_mesh), b = next(a, m_mesh), c = next(b, m_mesh);
    if (next(c, m_mesh) != a) {
      read_polygon(a, scratch);
      f(scratch.polygon, scratch.first);
      return;
    }
    const std::size_t to_a = target_rank(a), to_b = target_rank(b), to_c = target_rank(c);
    const bool from_b = (to_a < to_b) & (to_a < to_c), from_c = !from_b & (to_b < to_c);
    f(Triangle{a, b, c}, std::size_t(from_b + 2 * from_c));
  }

  /// Calls `f(halfedge, dual_edge)` for every dual edge of the flat mesh made by this walk, in order, with the
  /// halfedge of its lower face.
  template <typename F>
  void for_each_dual_edge(const F& f) const
  {
    Scratch scratch;
    std::size_t rank = 0, dual_edge = 0;
    for (face_descriptor fd : faces(m_mesh)) {
      with_boundary(fd, scratch, [&](const auto& around, std::size_t first) {
        read_lower_neighbors(rank, around, first, scratch.neighbors);
        for (const auto& neighbor : scratch.neighbors)
          f(opposite(neighbor.halfedge, m_mesh), dual_edge++);
      });
      ++rank;
    }
  }

private:
  void read_polygon(halfedge_descriptor start, Scratch& scratch) const
  {
    Polygon& around = scratch.polygon;
    around.clear();
    std::size_t lowest = none;
    halfedge_descriptor h = start;
    do {
      const std::size_t rank = source_rank(h);
      scratch.first = rank < lowest ? around.size() : scratch.first;
      lowest = (std::min)(rank, lowest);
      around.push_back(h);
      h = next(h, m_mesh);
    } while (h != start);
  }

  /// The lower neighbors of the face `rank`, in order; several halfedges to one of them follow the boundary.
  template <typename Boundary>
  void read_lower_neighbors(std::size_t rank, const Boundary& around, std::size_t first,
                            std::vector<typename Scratch::Neighbor>& neighbors) const
  {
    neighbors.clear();
    for (std::size_t i = 0; i < around.size(); ++i) {
      const halfedge_descriptor h = around[(first + i) % around.size()];
      if (const std::size_t other = opposite_face_rank(h); other < rank)
        neighbors.push_back({other, i, h});
    }
    std::sort(neighbors.begin(), neighbors.end(), [](const auto& a, const auto& b) {
      return a.face_rank != b.face_rank ? a.face_rank < b.face_rank : a.place < b.place;
    });
  }

  const FaceGraph& m_mesh;
  Iteration_ranks<Face_index_map, Face_range> m_face_ranks;
  Iteration_ranks<Vertex_index_map, Vertex_range> m_vertex_ranks;
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
