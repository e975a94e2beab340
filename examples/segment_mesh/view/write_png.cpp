// SPDX-License-Identifier: GPL-3.0-or-later

#include "view/write_png.h"

#include <png.h>

#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>
#include <unordered_map>

namespace segment_mesh {

namespace {

constexpr std::size_t largest_palette = 256;

/// The colors of an image in the order in which they occur, and the number of each pixel's.
struct Palette
{
  std::vector<Color> colors;
  std::vector<std::uint8_t> of_pixel;
  bool is_too_large = false;
};

Palette make_palette(const Image& image)
{
  Palette palette;
  palette.of_pixel.reserve(image.pixels.size());
  std::unordered_map<std::uint32_t, std::uint8_t> numbers;
  for (const Color& c : image.pixels) {
    const std::uint32_t key = std::uint32_t(c[0]) << 16 | std::uint32_t(c[1]) << 8 | c[2];
    const auto entry = numbers.emplace(key, std::uint8_t(palette.colors.size()));
    if (entry.second) {
      palette.is_too_large = palette.colors.size() == largest_palette;
      if (palette.is_too_large)
        return palette;
      palette.colors.push_back(c);
    }
    palette.of_pixel.push_back(entry.first->second);
  }
  return palette;
}

} // namespace

void write_png(const Image& image, std::ostream& out)
{
  static_assert(sizeof(Color) == 3, "the pixels are bytes without gaps");
  if (image.pixels.empty())
    throw std::runtime_error("an image without pixels cannot be written");
  const Palette palette = make_palette(image);
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  png.width = png_uint_32(image.width);
  png.height = png_uint_32(image.height);
  png.format = palette.is_too_large ? PNG_FORMAT_RGB : PNG_FORMAT_RGB_COLORMAP;
  png.colormap_entries = png_uint_32(palette.colors.size());
  const void* const pixels = palette.is_too_large ? static_cast<const void*>(image.pixels.data()) : palette.of_pixel.data();

  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::vector<char> bytes(size);
  constexpr int as_it_is = 0, rows_without_gaps = 0;
  if (png_image_write_to_memory(&png, bytes.data(), &size, as_it_is, pixels, rows_without_gaps, palette.colors.data()) == 0)
    throw std::runtime_error(std::string("libpng: ") + png.message);
  out.write(bytes.data(), std::streamsize(size));
}

void write_png_view(std::ostream& out, const Polygon_soup& soup,
                    const std::vector<std::size_t>& labels,
                    const std::vector<Vertex_pair>& feature_edges, const View_options& options)
{
  write_png(render_view(soup, labels, feature_edges, options), out);
}

} // namespace segment_mesh
