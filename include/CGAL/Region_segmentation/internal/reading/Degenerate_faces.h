// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_DEGENERATE_FACES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_DEGENERATE_FACES_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/reading/Corner_reader.h>
#include <CGAL/Region_segmentation/internal/reading/Mesh_traversal.h>
#include <CGAL/Region_segmentation/internal/reading/normals.h>
#include <CGAL/Region_segmentation/internal/support/blocks.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The faces of a mesh that are degenerate in a `Flat_mesh`, too: for stages that need no normals.
///
/// Bytes: the size of a vector per block, and 1/8 per face of blocks that have such faces.
template <typename FaceGraph, typename Pack>
class Degenerate_faces
{
public:
  /// \throws Invalid_input if a point is not finite
  template <typename ConcurrencyTag>
  Degenerate_faces(const Mesh_traversal<FaceGraph, Pack>& traversal, const Pack& np,
                   const Execution<ConcurrencyTag>& execution)
    : m_corners(traversal, np, execution)
    , m_blocks(number_of_blocks(traversal.number_of_faces()))
  {
    const double squared_certain_area = m_corners.certain_area() * m_corners.certain_area();
    m_corners.for_each_face(execution, [&](std::size_t face, std::size_t n, const auto& point) {
      const Double_3 area_vector = area_vector_of(n, point);
      if (!(squared_norm(area_vector) > squared_certain_area) &&
          internal::is_degenerate(norm(area_vector), squared_longest_edge(n, point)))
        mark(face);
    });
    m_are_any = std::any_of(m_blocks.begin(), m_blocks.end(), [](const auto& block) { return !block.empty(); });
  }

  bool is_degenerate(std::size_t face) const
  {
    return m_are_any && !m_blocks[face / block_size].empty() && m_blocks[face / block_size][face % block_size];
  }

  /// Of a halfedge, in the unit of a `Flat_mesh`.
  template <typename Halfedge>
  double length(const Halfedge& h) const
  {
    return norm(m_corners.direction(h));
  }

private:
  void mark(std::size_t face)
  {
    std::vector<bool>& block = m_blocks[face / block_size];
    block.resize(block_size);
    block[face % block_size] = true;
  }

  const Corner_reader<FaceGraph, Pack> m_corners;
  std::vector<std::vector<bool>> m_blocks; // whether a face is degenerate; empty if none of the block is
  bool m_are_any = false;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_DEGENERATE_FACES_H
