// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_PAGE_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_PAGE_H

#include "page/page_data.h"

#include <iosfwd>

namespace segment_mesh {

/// Whether the program was built with three.js.
bool can_write_pages();

/// Writes a page of HTML that needs no other file and no network: the mesh to view and rotate,
/// every number of segments that the merge tree has, and segments to split and to join. It needs a
/// browser with WebGL and `DecompressionStream` (of 2023). \pre `can_write_pages()`
void write_page(std::ostream& out, const Page_content& content);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_PAGE_H
