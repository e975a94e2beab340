// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RENDER_VIEW_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RENDER_VIEW_H

#include "soup/Polygon_soup.h"
#include "view/choose_viewpoint.h"
#include "view/segment_colors.h"

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <vector>

namespace segment_mesh {

/// Pixels in rows from the top.
struct Image
{
  std::size_t width, height;
  std::vector<Color> pixels;

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

struct View_options
{
  std::size_t width = 800, height = 600; ///< in pixels
  std::size_t samples = 2; ///< a side of a pixel, so that lines and outlines are smooth
  Color background = {255, 255, 255};
  Up_direction up;
  std::optional<Viewpoint> viewpoint; ///< by `choose_viewpoint()` if empty
  std::vector<std::size_t> colors;    ///< numbers by label; if empty, the labels
};

/// Draws a mesh: each segment shaded in the `segment_color()` of its number, its borders as dark
/// lines. Without a display or a GPU; the same
/// picture for the same input. Faces may be of any size, need not be convex or planar, and may be
/// turned either way; those that have no inside are not seen. \pre there are a label for each face
/// and a point for each corner
Image render_view(const Polygon_soup& soup, const std::vector<std::size_t>& labels,
                  const View_options& options = {});

/// Writes an image by libpng. No time and no name of a program is in it: the same bytes for the
/// same image. \throws std::runtime_error for an image without pixels, or if libpng fails; a
/// failure to write sets the state of `out`
void write_png(const Image& image, std::ostream& out);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RENDER_VIEW_H
