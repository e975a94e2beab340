// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_IMAGE_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_IMAGE_H

#include "view/segment_colors.h"

#include <cstddef>
#include <vector>

namespace segment_mesh {

/// Pixels in rows from the top.
struct Image
{
  std::size_t width = 0, height = 0;
  std::vector<Color> pixels;

  Image() = default;
  Image(std::size_t width, std::size_t height, const Color& color)
    : width(width)
    , height(height)
    , pixels(width * height, color)
  {}

  const Color& at(std::size_t column, std::size_t row) const
  {
    return pixels[row * width + column];
  }
  Color& at(std::size_t column, std::size_t row) { return pixels[row * width + column]; }
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_IMAGE_H
