// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENT_TRIANGLES_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENT_TRIANGLES_H

#include "write/Labelled_mesh.h"
#include "soup/triangulate_polygon.h"
#include "view/segment_colors.h"

#include <string>
#include <vector>

namespace segment_mesh {

/// A segment as a part of its own.
struct Segment_triangles
{
  std::string name; ///< `segment_I`
  Color color;
  std::vector<Point> points;
  Triangles triangles; ///< at least one; each has three different points
};

/// All segments with a face of at least three different points.
std::vector<Segment_triangles> triangles_of_segments(const Labelled_mesh& mesh);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENT_TRIANGLES_H
