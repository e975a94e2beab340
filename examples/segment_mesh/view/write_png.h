// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_PNG_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_PNG_H

#include "view/render_view.h"

#include <iosfwd>

namespace segment_mesh {

/// Writes an image by libpng. No time and no name of a program is in it: the same bytes for the
/// same image. \throws std::runtime_error for an image without pixels, or if libpng fails; a
/// failure to write
/// sets the state of `out`
void write_png(const Image& image, std::ostream& out);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_PNG_H
