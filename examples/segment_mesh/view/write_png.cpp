// SPDX-License-Identifier: GPL-3.0-or-later

#include "view/write_png.h"

#include <png.h>

#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace segment_mesh {

void write_png(const Image& image, std::ostream& out)
{
  static_assert(sizeof(Color) == 3, "the pixels are bytes without gaps");
  if (image.pixels.empty())
    throw std::runtime_error("an image without pixels cannot be written");
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  png.width = png_uint_32(image.width);
  png.height = png_uint_32(image.height);
  png.format = PNG_FORMAT_RGB;

  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::vector<char> bytes(size);
  constexpr int as_it_is = 0, rows_without_gaps = 0;
  if (png_image_write_to_memory(&png, bytes.data(), &size, as_it_is, image.pixels.data(),
                                rows_without_gaps, nullptr) == 0)
    throw std::runtime_error(std::string("libpng: ") + png.message);
  out.write(bytes.data(), std::streamsize(size));
}

} // namespace segment_mesh
