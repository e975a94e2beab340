// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LOOKS_LIKE_MACHINE_PART_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LOOKS_LIKE_MACHINE_PART_H

#include "soup/Polygon_soup.h"

namespace segment_mesh {

/// Whether more than a fifth of the area is in several planes, each with several faces and 1/100 of
/// it: what a CAD program makes is so, what a scanner or a sculptor makes hardly ever.
bool looks_like_machine_part(const Polygon_soup& soup);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LOOKS_LIKE_MACHINE_PART_H
