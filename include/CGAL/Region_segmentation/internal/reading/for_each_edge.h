// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_FOR_EACH_EDGE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_FOR_EACH_EDGE_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/reading/Mesh_traversal.h>
#include <CGAL/Region_segmentation/internal/support/blocks.h>
#include <CGAL/Region_segmentation/internal/support/visitor.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <iterator>
#include <limits>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// An edge of a mesh and the faces on both sides.
template <typename FaceGraph>
struct Mesh_edge
{
  static constexpr std::size_t no_face = (std::numeric_limits<std::size_t>::max)();

  std::size_t rank; // in the order of edges
  typename boost::graph_traits<FaceGraph>::edge_descriptor descriptor;
  typename boost::graph_traits<FaceGraph>::halfedge_descriptor halfedge; // of the first face
  std::size_t face, other_face;

  bool is_border() const { return face == no_face || other_face == no_face; }
  /// Whether it has a dual edge: an edge that ends inside a face has the same face on both sides.
  bool has_two_faces() const { return !is_border() && face != other_face; }
};

/// Calls `f(edge)` for the edges of a mesh in their order: for a function that needs no order of dual edges this takes less
/// than the boundaries of faces. `f` is best a small copy of what it needs (12 in place of 15 ns per face).
template <typename ConcurrencyTag, typename FaceGraph, typename Pack, typename F>
void for_each_edge(const Mesh_traversal<FaceGraph, Pack>& traversal, const Execution<ConcurrencyTag>& execution, F f)
{
  using Traits = boost::graph_traits<FaceGraph>;
  const FaceGraph& mesh = traversal.mesh();
  const auto rank_of_face = traversal.rank_of_face();
  const auto rank_or_none = [&](typename Traits::halfedge_descriptor h) {
    const auto fd = face(h, mesh);
    return fd == Traits::null_face() ? Mesh_edge<FaceGraph>::no_face : rank_of_face(fd);
  };
  Step_counter<ConcurrencyTag> blocks(execution, number_of_blocks(num_edges(mesh)));
  const auto range = edges(mesh);
  std::size_t rank = 0;
  for (auto it = std::begin(range), end = std::end(range); it != end;) {
    // Without reports, so that what `f` needs stays in registers.
    for (const std::size_t end_of_block = rank + block_size; rank < end_of_block && it != end; ++rank, ++it) {
      const auto e = *it;
      const auto h = halfedge(e, mesh);
      f(Mesh_edge<FaceGraph>{rank, e, h, rank_or_none(h), rank_or_none(opposite(h, mesh))});
    }
    blocks.advance();
  }
  execution.report(1);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_FOR_EACH_EDGE_H
