// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MESH_ORDER_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MESH_ORDER_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/exceptions.h>
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

/// The position of a descriptor in its range, found by an index map of any numbering, and the range
/// in blocks. Takes 4 bytes per element unless the index is the position.
///
/// Descriptors that are handles are stored in an array, with 8 bytes per element: the latencies of
/// traversing a linked list add up, while those of several handles overlap.
template <typename IndexMap, typename Range>
class Iteration_ranks
{
  using Iterator = decltype(std::begin(std::declval<const Range&>()));

public:
  using Descriptor = typename boost::property_traits<IndexMap>::key_type;

private:
  static constexpr bool are_handles = sizeof(Descriptor) > sizeof(Surface::Index);
  using Block_iterator = std::conditional_t<
    are_handles, typename std::vector<Descriptor>::const_iterator, Iterator>;

public:
  /// Maps a descriptor to its position; small enough that loops keep a copy in registers.
  class Rank_of
  {
  public:
    Rank_of(IndexMap index_map, const Surface::Index* ranks)
      : m_index_map(index_map)
      , m_ranks(ranks)
    {}

    std::size_t operator()(const Descriptor& d) const
    {
      const std::size_t index = get(m_index_map, d);
      return m_ranks ? m_ranks[index] : index;
    }

  private:
    IndexMap m_index_map;
    const Surface::Index* m_ranks; // null where an index is the position
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
    CGAL_precondition_msg(m_size < (std::numeric_limits<Surface::Index>::max)(),
                          "a mesh has fewer than 2^32 - 1 vertices, faces and edges");
    if (is_identity)
      return;
    m_ranks = std::make_unique<Surface::Index[]>(capacity);
    Surface::Index rank = 0;
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
  std::unique_ptr<Surface::Index[]> m_ranks;
  std::vector<Iterator> m_block_starts; // and the end; only of indices
  std::vector<Descriptor> m_handles;
};

/// The order of the elements of a face graph, which does not depend on its type: faces and vertices
/// are numbered by iteration, and the boundary of a face begins at its vertex of lowest number.
template <typename FaceGraph, typename Pack>
class Mesh_order
{
  using Traits = boost::graph_traits<FaceGraph>;
  using Face_index_map = typename GetInitializedFaceIndexMap<FaceGraph, Pack>::const_type;
  using Vertex_index_map = typename GetInitializedVertexIndexMap<FaceGraph, Pack>::const_type;
  using Face_range = std::decay_t<decltype(faces(std::declval<const FaceGraph&>()))>;
  using Vertex_range = std::decay_t<decltype(vertices(std::declval<const FaceGraph&>()))>;

public:
  using face_descriptor = typename Traits::face_descriptor;
  using halfedge_descriptor = typename Traits::halfedge_descriptor;
  using edge_descriptor = typename Traits::edge_descriptor;

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
  auto rank_of_face() const { return m_faces.rank_of(); }
  auto rank_of_vertex() const { return m_vertices.rank_of(); }

  /// The faces and vertices with the numbers of one block.
  auto faces_of_block(std::size_t block) const { return m_faces.block(block); }
  auto vertices_of_block(std::size_t block) const { return m_vertices.block(block); }

  /// The number of the face of a halfedge; `none` at a border.
  Surface::Index face_rank(halfedge_descriptor h) const
  {
    const face_descriptor f = face(h, m_mesh);
    return f == Traits::null_face() ? none : Surface::Index(m_faces[f]);
  }

  /// Calls `f(face)` in order.
  template <typename F>
  void for_each_face(const F& f) const
  {
    for (std::size_t block = 0; block < number_of_blocks(number_of_faces()); ++block)
      for (face_descriptor fd : faces_of_block(block))
        f(fd);
  }

private:
  const FaceGraph& m_mesh;
  Iteration_ranks<Face_index_map, Face_range> m_faces;
  Iteration_ranks<Vertex_index_map, Vertex_range> m_vertices;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MESH_ORDER_H
