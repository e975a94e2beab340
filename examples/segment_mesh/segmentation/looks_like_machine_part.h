// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LOOKS_LIKE_MACHINE_PART_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LOOKS_LIKE_MACHINE_PART_H

#include "segmentation/run_segmentation.h"
#include "soup/Polygon_soup.h"

namespace segment_mesh {

/// Whether the faces of a mesh are likely to be better segments than the parts that the method
/// learned chose: one of these has more than 0.85 of the area, and edges of more than 20 degrees
/// divide the mesh into at least 5 regions that have 0.001 of it. For all but 1 in 20 meshes the
/// first condition costs all: a sum over the faces.
bool looks_like_machine_part(const Polygon_soup& soup, const Segmentation& learned);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LOOKS_LIKE_MACHINE_PART_H
