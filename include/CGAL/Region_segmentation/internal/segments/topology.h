// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_TOPOLOGY_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_TOPOLOGY_H

#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/support/Lowest_root_forest.h>
#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>
#include <CGAL/Region_segmentation/internal/segments/border_loops.h>

#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The numbers of a segment as a surface whose vertices are the fans of its faces.
struct Surface_counts
{
  std::size_t components = 0, loops = 0, faces = 0;
  std::size_t sides = 0;             // halfedges of its faces
  std::size_t border_sides = 0;      // those on its border: one for each fan that is open
  std::size_t interior_vertices = 0; // closed fans

  std::ptrdiff_t euler_characteristic() const
  {
    const std::size_t edges = (sides + border_sides) / 2, vertices = interior_vertices + border_sides;
    return std::ptrdiff_t(vertices) - std::ptrdiff_t(edges) + std::ptrdiff_t(faces);
  }
  bool is_disc() const { return components == 1 && loops == 1 && euler_characteristic() == 1; }
};

/// The connected components of the segments across edges; faces without a segment are components of their own.
template <typename Traversal>
Partition components_of_segments(const Segmented_mesh<Traversal>& segmented)
{
  Lowest_root_forest forest(segmented.segment_of_face().size());
  const auto rank = segmented.traversal().rank_of_face();
  for (auto e : edges(segmented.mesh())) {
    const auto h = halfedge(e, segmented.mesh());
    if (!segmented.is_border(h) && segmented.segment(h) != segmented.none)
      forest.unite(Partition::Index(rank(face(h, segmented.mesh()))),
                   Partition::Index(rank(face(opposite(h, segmented.mesh()), segmented.mesh()))));
  }
  return forest.take_partition();
}

template <typename FaceGraph, typename Pack>
std::vector<Surface_counts> count_surfaces(const Segmented_mesh<Mesh_traversal<FaceGraph, Pack>>& segmented,
                                           const Pack& np, std::size_t number_of_segments)
{
  const FaceGraph& mesh = segmented.mesh();
  const auto none = segmented.none;
  std::vector<Surface_counts> counts(number_of_segments);
  for (auto segment : segmented.segment_of_face())
    if (segment != none)
      ++counts[segment].faces;
  std::vector<char> is_interior(segmented.traversal().number_of_vertices(), true);
  for (auto e : edges(mesh)) {
    const auto h = halfedge(e, mesh), o = opposite(h, mesh);
    const auto left = segmented.segment(h), right = segmented.segment(o);
    for (auto segment : {left, right})
      if (segment != none) {
        ++counts[segment].sides;
        counts[segment].border_sides += left != right;
      }
    if (left != right || left == none)
      is_interior[segmented.traversal().source_rank(h)] = is_interior[segmented.traversal().source_rank(o)] = false;
  }
  std::size_t rank = 0;
  for (auto v : vertices(mesh)) {
    const auto h = halfedge(v, mesh);
    if (is_interior[rank++] && h != boost::graph_traits<FaceGraph>::null_halfedge())
      ++counts[segmented.segment(h)].interior_vertices;
  }
  for_each_border_loop(segmented, np, [&](auto segment, const auto&) { ++counts[segment].loops; });

  const Partition components = components_of_segments(segmented);
  for (std::size_t f = 0, next = 0; f < components.size(); ++f)
    if (components[f] == next) {
      ++next;
      if (segmented.segment_of_face()[f] != none)
        ++counts[segmented.segment_of_face()[f]].components;
    }
  return counts;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_TOPOLOGY_H
