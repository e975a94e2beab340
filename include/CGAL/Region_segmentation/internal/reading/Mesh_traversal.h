// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_MESH_TRAVERSAL_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_MESH_TRAVERSAL_H

#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/support/blocks.h>
#include <CGAL/Region_segmentation/parameters.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The position of a descriptor in its range, found by an index map of any numbering, and the range in blocks. Takes 4
/// bytes per element unless the index is the position.
///
/// Descriptors that are handles are stored in an array, with 8 bytes per element: the latencies of traversing a linked
/// list add up, while those of several handles overlap.
template <typename IndexMap, typename Range>
class Iteration_ranks
{
  using Iterator = decltype(std::begin(std::declval<const Range&>()));

public:
  using Descriptor = typename boost::property_traits<IndexMap>::key_type;

private:
  static constexpr bool are_handles = sizeof(Descriptor) > sizeof(Flat_mesh::Index);
  using Block_iterator =
    std::conditional_t<are_handles, typename std::vector<Descriptor>::const_iterator, Iterator>;

public:
  /// Maps a descriptor to its position; small enough that loops keep a copy in registers.
  class Rank_of
  {
  public:
    Rank_of(IndexMap index_map, const Flat_mesh::Index* ranks) : m_index_map(index_map), m_ranks(ranks) {}

    std::size_t operator()(const Descriptor& d) const
    {
      const std::size_t index = get(m_index_map, d);
      return m_ranks ? m_ranks[index] : index;
    }

  private:
    IndexMap m_index_map;
    const Flat_mesh::Index* m_ranks; // null where an index is the position
  };

  /// `capacity`: an upper bound of the indices, removed elements of the mesh included.
  Iteration_ranks(IndexMap index_map, const Range& range, std::size_t capacity)
    : m_index_map(index_map)
  {
    bool is_identity = true;
    for (Iterator it = std::begin(range), end = std::end(range); it != end;) {
      if constexpr (!are_handles)
        m_block_starts.push_back(it);
      std::size_t i = 0;
      for (; i < block_size && it != end; ++i, ++it) {
        const Descriptor d = *it;
        is_identity &= std::size_t(get(m_index_map, d)) == m_size + i;
        if constexpr (are_handles)
          m_handles.push_back(d);
      }
      m_size += i;
    }
    if constexpr (!are_handles)
      m_block_starts.push_back(std::end(range));
    CGAL_precondition_msg(m_size < (std::numeric_limits<Flat_mesh::Index>::max)(),
                          "a mesh has fewer than 2^32 - 1 vertices, faces and edges");
    if (is_identity)
      return;
    m_ranks = std::make_unique<Flat_mesh::Index[]>(capacity);
    Flat_mesh::Index rank = 0;
    for (const auto& d : range) {
      const std::size_t index = get(m_index_map, d);
      CGAL_precondition_msg(index < capacity, "an index map has values from 0 to the size - 1");
      m_ranks[index] = rank++;
    }
  }

  std::size_t size() const { return m_size; }

  Rank_of rank_of() const { return Rank_of(m_index_map, m_ranks.get()); }
  std::size_t operator[](const Descriptor& d) const { return rank_of()(d); }

  /// The elements of a block.
  CGAL::Iterator_range<Block_iterator> block(std::size_t i) const
  {
    if constexpr (are_handles)
      return {m_handles.begin() + std::ptrdiff_t(i * block_size),
              m_handles.begin() + std::ptrdiff_t((std::min)((i + 1) * block_size, m_size))};
    else
      return {m_block_starts[i], m_block_starts[i + 1]};
  }

private:
  IndexMap m_index_map;
  std::size_t m_size = 0;
  std::unique_ptr<Flat_mesh::Index[]> m_ranks;
  std::vector<Iterator> m_block_starts; // and the end; only of indices
  std::vector<Descriptor> m_handles;
};

/// Traversal of a face graph in an order that does not depend on its type: faces and vertices are
/// numbered by iteration, and the boundary of a face begins at its vertex of lowest number.
template <typename FaceGraph, typename Pack>
class Mesh_traversal
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
  using Boundary = std::vector<halfedge_descriptor>;

  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  /// \throws Invalid_input if there are too many halfedges
  Mesh_traversal(const FaceGraph& mesh, const Pack& np)
    : m_mesh(mesh)
    , m_face_ranks(get_initialized_face_index_map(mesh, np), faces(mesh), num_faces(mesh))
    , m_vertex_ranks(get_initialized_vertex_index_map(mesh, np), vertices(mesh),
                     num_vertices(mesh))
  {
    // Corners, and steps between faces, are counted in 32 bits.
    if (num_halfedges(mesh) >= (std::numeric_limits<Flat_mesh::Index>::max)())
      throw Invalid_input("a mesh has fewer than 2^32 - 1 halfedges");
  }

  const FaceGraph& mesh() const { return m_mesh; }
  std::size_t number_of_faces() const { return m_face_ranks.size(); }
  std::size_t number_of_vertices() const { return m_vertex_ranks.size(); }

  auto rank_of_face() const { return m_face_ranks.rank_of(); }
  auto rank_of_vertex() const { return m_vertex_ranks.rank_of(); }

  std::size_t source_rank(halfedge_descriptor h) const { return m_vertex_ranks[source(h, m_mesh)]; }

  /// The number of the face on the other side of a halfedge; `none` at a border.
  std::size_t opposite_face_rank(halfedge_descriptor h) const
  {
    const face_descriptor f = face(opposite(h, m_mesh), m_mesh);
    return f == Traits::null_face() ? none : m_face_ranks[f];
  }

  /// The faces and vertices with the numbers of one block.
  auto faces_of_block(std::size_t block) const { return m_face_ranks.block(block); }
  auto vertices_of_block(std::size_t block) const { return m_vertex_ranks.block(block); }

  /// Replaces the contents of `boundary` by the boundary of a face.
  void read_boundary(face_descriptor face, Boundary& boundary) const
  {
    boundary.clear();
    std::size_t lowest = none, first = 0;
    for (halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(face, m_mesh), m_mesh)) {
      const std::size_t rank = source_rank(h);
      if (rank < lowest) {
        lowest = rank;
        first = boundary.size();
      }
      boundary.push_back(h);
    }
    std::rotate(boundary.begin(), boundary.begin() + std::ptrdiff_t(first), boundary.end());
  }

  /// Calls `f(halfedge, dual_edge)` for the dual edges of the faces of a block, from `dual_edge` on, as the flat mesh
  /// made by this traversal has them, with the halfedge of the lower face. Returns the dual edge that follows.
  template <typename F>
  std::size_t for_each_dual_edge_of_block(std::size_t block, std::size_t dual_edge, const F& f) const
  {
    Dual_edges_of_face edges;
    std::size_t rank = block * block_size;
    for (face_descriptor fd : faces_of_block(block))
      dual_edge = for_each_dual_edge_of_face(fd, rank++, dual_edge, edges, f);
    return dual_edge;
  }

  /// Calls `f(halfedge, dual_edge)` for those dual edges of a flat mesh made by this traversal whose mesh edges
  /// `is_wanted`. O(F), fast where few are.
  template <typename IsWanted, typename F>
  void for_each_dual_edge_if(const Flat_mesh& flat, const IsWanted& is_wanted, const F& f) const
  {
    for_each_dual_edge_if(is_wanted, [&](std::size_t face) { return flat.first_edge(face); }, f);
  }

  /// The same, in order; `first_edge(face)`: the first dual edge of a higher face.
  template <typename IsWanted, typename FirstEdge, typename F>
  void for_each_dual_edge_if(const IsWanted& is_wanted, const FirstEdge& first_edge, const F& f) const
  {
    std::vector<std::pair<std::size_t, face_descriptor>> higher_faces; // with such an edge
    for (auto e : edges(m_mesh))
      if (is_wanted(e) && !CGAL::is_border(e, m_mesh)) {
        const halfedge_descriptor h = halfedge(e, m_mesh);
        const std::size_t rank = opposite_face_rank(opposite(h, m_mesh)), other = opposite_face_rank(h);
        higher_faces.push_back({(std::max)(rank, other), face(rank > other ? h : opposite(h, m_mesh), m_mesh)});
      }
    std::sort(higher_faces.begin(), higher_faces.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    Dual_edges_of_face of_face;
    std::size_t previous = none;
    for (const auto& [rank, fd] : higher_faces)
      if (std::exchange(previous, rank) != rank)
        for_each_dual_edge_of_face(fd, rank, first_edge(rank), of_face, [&](auto h, std::size_t dual_edge) {
          if (is_wanted(edge(h, m_mesh)))
            f(h, dual_edge);
        });
  }

  /// Calls `f(face)` in order.
  template <typename F>
  void for_each_face(const F& f) const
  {
    for (std::size_t block = 0; block < number_of_blocks(number_of_faces()); ++block)
      for (face_descriptor fd : faces_of_block(block))
        f(fd);
  }

  template <typename F>
  void for_each_dual_edge(const F& f) const
  {
    std::size_t dual_edge = 0;
    for (std::size_t block = 0; block < number_of_blocks(number_of_faces()); ++block)
      dual_edge = for_each_dual_edge_of_block(block, dual_edge, f);
  }

private:
  /// Memory for the dual edges of a face, reused for each face.
  struct Dual_edges_of_face
  {
    Boundary boundary;
    std::vector<std::pair<std::size_t, halfedge_descriptor>> lower_neighbors;
  };

  template <typename F>
  std::size_t for_each_dual_edge_of_face(face_descriptor fd, std::size_t rank, std::size_t dual_edge,
                                         Dual_edges_of_face& memory, const F& f) const
  {
    read_boundary(fd, memory.boundary);
    memory.lower_neighbors.clear();
    for (halfedge_descriptor h : memory.boundary)
      if (const std::size_t other = opposite_face_rank(h); other < rank)
        memory.lower_neighbors.push_back({other, opposite(h, m_mesh)});
    std::stable_sort(memory.lower_neighbors.begin(), memory.lower_neighbors.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& neighbor : memory.lower_neighbors)
      f(neighbor.second, dual_edge++);
    return dual_edge;
  }

  const FaceGraph& m_mesh;
  Iteration_ranks<Face_index_map, Face_range> m_face_ranks;
  Iteration_ranks<Vertex_index_map, Vertex_range> m_vertex_ranks;
};

template <typename FaceGraph, typename Pack>
Mesh_traversal<FaceGraph, Pack> make_mesh_traversal(const FaceGraph& mesh, const Pack& np)
{
  return Mesh_traversal<FaceGraph, Pack>(mesh, np);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_MESH_TRAVERSAL_H
