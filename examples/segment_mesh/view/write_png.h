// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_PNG_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_PNG_H

#include "view/render_view.h"

#include <cstddef>
#include <iosfwd>
#include <vector>

namespace segment_mesh {

/// Writes an image by libpng. No time and no name of a program is in it: the same bytes for the
/// same image. \throws std::runtime_error for an image without pixels, or if libpng fails; a
/// failure to write
///         sets the state of `out`
void write_png(const Image& image, std::ostream& out);

/// Renders and writes a view of a segmented mesh; see `render_view()`.
void write_png_view(std::ostream& out, const Polygon_soup& soup,
                    const std::vector<std::size_t>& labels,
                    const std::vector<Vertex_pair>& feature_edges,
                    const View_options& options = {});

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WRITE_PNG_H
