// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_EMBEDDED_TEXTS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_EMBEDDED_TEXTS_H

namespace segment_mesh {
namespace embedded {

/// \name The parts of a page: files of this folder, and of three.js
/// @{
extern const char* const page_html;
extern const char* const page_css;
extern const char* const mesh_view_js;
extern const char* const merge_tree_js;
extern const char* const page_js;
extern const char* const read_arrays_js;
extern const char* const show_saved_js;
extern const char* const three_js;
extern const char* const controls_js;
/// @}

} // namespace embedded
} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_EMBEDDED_TEXTS_H
