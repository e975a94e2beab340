// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_REDUCE_COLORS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_REDUCE_COLORS_H

#include "view/Image.h"

#include <cstddef>

namespace segment_mesh {

/// Leaves at most `number_of_colors` (at least 1) in an image, by median cut: the box of colors
/// with the largest spread is cut at its median until there are enough, and each color becomes the
/// mean of its box. Source: P. Heckbert, "Color Image Quantization for Frame Buffer Display",
/// SIGGRAPH 1982.
void reduce_colors(Image& image, std::size_t number_of_colors);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_REDUCE_COLORS_H
