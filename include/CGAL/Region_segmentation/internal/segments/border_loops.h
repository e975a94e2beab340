// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_BORDER_LOOPS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_BORDER_LOOPS_H

#include <CGAL/Region_segmentation/internal/segments/Halfedge_values.h>
#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>

#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Calls `f(segment, loop)` for each loop of the borders of segments, with its halfedges in order. Loops come in the
/// order of their first faces.
template <typename FaceGraph, typename Pack, typename F>
void for_each_border_loop(const Segmented_mesh<Mesh_traversal<FaceGraph, Pack>>& segmented, const Pack& np, const F& f)
{
  using halfedge_descriptor = typename Mesh_traversal<FaceGraph, Pack>::halfedge_descriptor;
  Halfedge_values<FaceGraph, Pack, char> is_done(segmented.mesh(), np, false);
  std::vector<halfedge_descriptor> loop;
  segmented.for_each_border_halfedge([&](halfedge_descriptor start, auto segment) {
    if (is_done[start])
      return;
    loop.clear();
    for (halfedge_descriptor h = start; !is_done[h]; h = segmented.next_on_border(h)) {
      is_done[h] = true;
      loop.push_back(h);
    }
    f(segment, loop);
  });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_BORDER_LOOPS_H
