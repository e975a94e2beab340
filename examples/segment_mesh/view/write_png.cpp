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

/// Holds libpng's two structures, and frees them also when an exception passes.
class Png_writer
{
public:
  explicit Png_writer(std::ostream& out)
      : m_png(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore)),
        m_info(m_png ? png_create_info_struct(m_png) : nullptr)
  {
    if (!m_info) {
      png_destroy_write_struct(&m_png, nullptr);
      throw std::runtime_error("libpng cannot be started");
    }
    png_set_write_fn(m_png, &out, append, nullptr);
  }
  Png_writer(const Png_writer&) = delete;
  Png_writer& operator=(const Png_writer&) = delete;
  ~Png_writer() { png_destroy_write_struct(&m_png, &m_info); }

  void write_header(const Image& image, const Palette& palette)
  {
    const int type = palette.is_too_large ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_PALETTE;
    png_set_IHDR(m_png, m_info, png_uint_32(image.width), png_uint_32(image.height), 8, type,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    std::vector<png_color> colors;
    for (const Color& c : palette.colors)
      colors.push_back({c[0], c[1], c[2]});
    if (!palette.is_too_large)
      png_set_PLTE(m_png, m_info, colors.data(), int(colors.size()));
    png_write_info(m_png, m_info);
  }

  void write_rows(const std::uint8_t* bytes, std::size_t bytes_a_row, std::size_t number_of_rows)
  {
    for (std::size_t i = 0; i < number_of_rows; ++i)
      png_write_row(m_png, bytes + i * bytes_a_row);
    png_write_end(m_png, m_info);
  }

private:
  [[noreturn]] static void fail(png_structp, png_const_charp message)
  {
    throw std::runtime_error(std::string("libpng: ") + message);
  }
  static void ignore(png_structp, png_const_charp) {}
  static void append(png_structp png, png_bytep bytes, png_size_t size)
  {
    auto& out = *static_cast<std::ostream*>(png_get_io_ptr(png));
    out.write(reinterpret_cast<const char*>(bytes), std::streamsize(size));
  }

  png_structp m_png;
  png_infop m_info;
};

} // namespace

void write_png(const Image& image, std::ostream& out)
{
  static_assert(sizeof(Color) == 3, "the pixels are bytes without gaps");
  if (image.pixels.empty())
    throw std::runtime_error("an image without pixels cannot be written");
  const Palette palette = make_palette(image);
  Png_writer writer(out);
  writer.write_header(image, palette);
  if (palette.is_too_large)
    writer.write_rows(image.pixels.data()->data(), 3 * image.width, image.height);
  else
    writer.write_rows(palette.of_pixel.data(), image.width, image.height);
}

void write_png_view(std::ostream& out, const Polygon_soup& soup,
                    const std::vector<std::size_t>& labels,
                    const std::vector<Vertex_pair>& feature_edges, const View_options& options)
{
  write_png(render_view(soup, labels, feature_edges, options), out);
}

} // namespace segment_mesh
