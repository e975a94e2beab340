// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MARKS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MARKS_H

#include "soup/Polygon_soup.h"

#include <cstddef>
#include <vector>

namespace segment_mesh {

/// The seed of a face that has none.
constexpr std::size_t no_seed = std::size_t(-1);

/// Edges and faces of the mesh to be segmented that a user marked.
struct Marks
{
  std::vector<Vertex_pair> constrained_edges; ///< sorted, each with the lower point first
  std::vector<std::size_t> seed_of_face;      ///< or `no_seed`; empty if no face has one
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MARKS_H
