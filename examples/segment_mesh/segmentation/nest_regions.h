// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_NEST_REGIONS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_NEST_REGIONS_H

#include "segmentation/run_segmentation.h"

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <queue>
#include <vector>

namespace segment_mesh {

/// After borders were moved: a face that changed its segment gets the region of the nearest face, across edges, that
/// stayed in that segment, so that again every region lies in one segment.
/// \param segment_of_region before the borders were moved
template <typename Mesh>
void nest_regions(const Mesh& mesh, const std::vector<std::size_t>& segment_of_region, Segmentation& result)
{
  using Face = typename boost::graph_traits<Mesh>::face_descriptor;
  const auto index = get(boost::face_index, mesh);
  const auto has_moved = [&](std::size_t f) {
    return segment_of_region[result.region_of_face[f]] != result.segment_of_face[f];
  };
  std::queue<Face> front;
  for (const Face f : faces(mesh))
    if (!has_moved(get(index, f)))
      front.push(f);
  for (; !front.empty(); front.pop()) {
    const std::size_t f = get(index, front.front());
    for (const auto h : CGAL::halfedges_around_face(halfedge(front.front(), mesh), mesh)) {
      const auto across = opposite(h, mesh);
      if (CGAL::is_border(across, mesh))
        continue;
      const std::size_t g = get(index, face(across, mesh));
      if (!has_moved(g) || result.segment_of_face[g] != result.segment_of_face[f])
        continue;
      result.region_of_face[g] = result.region_of_face[f];
      front.push(face(across, mesh));
    }
  }
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_NEST_REGIONS_H
