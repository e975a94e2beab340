// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_FIND_SEAMS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_FIND_SEAMS_H

#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/segments/Seam_finder.h>
#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>
#include <CGAL/Region_segmentation/internal/support/Edge_marks.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The vertices on the border of a segment or of the mesh.
template <typename Traversal>
std::vector<char> border_vertices(const Segmented_mesh<Traversal>& segmented)
{
  std::vector<char> is_border(segmented.traversal().number_of_vertices(), false);
  for (auto e : edges(segmented.mesh())) {
    const auto h = halfedge(e, segmented.mesh());
    if (segmented.is_border(h))
      is_border[segmented.traversal().source_rank(h)] =
        is_border[segmented.traversal().source_rank(opposite(h, segmented.mesh()))] = true;
  }
  return is_border;
}

/// The dual edges of the seams that open the components of those segments that `is_opened(segment)` to discs.
///
/// `concave_gain` (1/radian): how much cheaper a seam along concave edges is.
template <typename Traversal, typename IsOpened>
Edge_marks find_seams(const Segmented_mesh<Traversal>& segmented, const Flat_mesh& flat, double concave_gain,
                      const IsOpened& is_opened)
{
  const Traversal& traversal = segmented.traversal();
  const auto& segment_of_face = segmented.segment_of_face();
  std::vector<Inner_edge> edges;
  std::vector<std::size_t> dual_edges;
  traversal.for_each_dual_edge([&](auto h, std::size_t e) {
    const std::uint32_t lower = flat.lower_face(e), higher = flat.higher_face(e);
    const auto segment = segment_of_face[lower];
    if (segment == segmented.none || segment != segment_of_face[higher] || !is_opened(segment))
      return;
    const double concavity = flat.has_flag(e, Flat_mesh::CONCAVE) ? flat.deviation(lower, e) : 0;
    edges.push_back({{std::uint32_t(traversal.source_rank(h)),
                      std::uint32_t(traversal.source_rank(opposite(h, traversal.mesh())))},
                     {lower, higher},
                     flat.length(e) / (1 + concave_gain * concavity)});
    dual_edges.push_back(e);
  });
  const std::vector<char> is_seam =
    Seam_finder(std::move(edges), border_vertices(segmented), flat.number_of_faces()).find();
  Edge_marks marks(flat.number_of_edges(), std::uint8_t(false));
  for (std::size_t i = 0; i < dual_edges.size(); ++i)
    marks[dual_edges[i]] = std::uint8_t(is_seam[i]);
  return marks;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_FIND_SEAMS_H
