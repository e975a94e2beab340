// SPDX-License-Identifier: GPL-3.0-or-later

#include "view/render_view.h"

#include "soup/vector_algebra.h"
#include "view/Corner_normals.h"
#include "view/Sample_buffer.h"
#include "view/Scene.h"
#include "view/choose_viewpoint.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace segment_mesh {

namespace {

/// A soft key light from the upper left, a fill light from the viewer, and a narrow highlight.
class Lamp
{
public:
  explicit Lamp(const Viewpoint& v)
    : m_key(unit_vector(plus(plus(times(-0.5, v.right), times(0.8, v.up)), v.toward_viewer)))
    , m_fill(v.toward_viewer)
    , m_half_way(unit_vector(plus(m_key, m_fill)))
  {}

  /// 1 shows a color as it is, 0 is black, 2 would be white. Both sides of a surface are lit.
  double operator()(const Point& outward) const
  {
    const Point normal = times(inner_product(outward, m_fill) < 0 ? -1 : 1, outward);
    const double wrapped = 0.5 + 0.5 * inner_product(normal, m_key); // no hard edge of the shadow
    const double facing = inner_product(normal, m_fill);
    const double highlight = std::pow(std::fmax(0.0, inner_product(normal, m_half_way)), 24);
    return 0.42 + 0.47 * wrapped * wrapped + 0.27 * facing + 0.14 * highlight;
  }

private:
  Point m_key, m_fill, m_half_way;
};

void draw_lit_faces(const Scene& scene, const Projection& projection, const Viewpoint& viewpoint,
                    Sample_buffer& buffer)
{
  const Corner_normals normals(scene.soup.points, scene.soup.polygons);
  const Lamp lamp(viewpoint);
  draw_faces(
    scene, projection, [&](std::size_t f, std::size_t p) { return lamp(normals.at(f, p)); },
    buffer);
}

/// Where two neighboring samples show different segments: borders, and outlines of one segment
/// before another. The radius of a line is in samples; none is on the background.
void draw_borders(const Scene& scene, double radius, Sample_buffer& buffer)
{
  const auto label = [&](std::size_t column, std::size_t row) -> std::optional<std::size_t> {
    if (column >= buffer.width() || row >= buffer.height() ||
        buffer.at(column, row).face == Sample_buffer::no_face)
      return std::nullopt;
    return scene.labels[buffer.at(column, row).face];
  };
  for (std::size_t y = 0; y < buffer.height(); ++y)
    for (std::size_t x = 0; x < buffer.width(); ++x) {
      const auto here = label(x, y), right = label(x + 1, y), below = label(x, y + 1);
      if (here && ((right && *right != *here) || (below && *below != *here)))
        buffer.for_each_near(x, y, radius, [](auto& sample) { sample.is_inked = true; });
    }
}

/// Adds what a sample shows to channels from 0 to 255: toward black below a light of 1, toward
/// white above.
void add_sample(const Color& color, float light, float paint, std::array<float, 3>& sum)
{
  const float glow = (std::min)((std::max)(light - 1, 0.0f), 1.0f);
  for (std::size_t j = 0; j < 3; ++j)
    sum[j] += paint * ((std::min)(light, 1.0f) * color[j] + glow * float(255 - color[j]));
}

/// Each pixel is the mean of its samples.
Image resolve(const Scene& scene, const Sample_buffer& buffer, const View_options& options,
              std::size_t samples)
{
  constexpr float paint_below_ink = 0.16f;
  Image image(options.width, options.height, options.background);
  for (std::size_t y = 0; y < image.height; ++y)
    for (std::size_t x = 0; x < image.width; ++x) {
      std::array<float, 3> sum = {0, 0, 0};
      for (std::size_t row = y * samples; row < (y + 1) * samples; ++row)
        for (std::size_t column = x * samples; column < (x + 1) * samples; ++column) {
          const Sample_buffer::Sample& sample = buffer.at(column, row);
          if (sample.face == Sample_buffer::no_face) {
            add_sample(options.background, 1, 1, sum);
            continue;
          }
          const std::size_t label = scene.labels[sample.face];
          add_sample(segment_color(label < options.colors.size() ? options.colors[label] : label),
                     sample.light, sample.is_inked ? paint_below_ink : 1, sum);
        }
      for (std::size_t j = 0; j < 3; ++j)
        image.at(x, y)[j] = std::uint8_t(sum[j] / float(samples * samples) + 0.5f);
    }
  return image;
}

} // namespace

Image render_view(const Polygon_soup& soup, const std::vector<std::size_t>& labels,
                  const View_options& options)
{
  constexpr double margin = 0.04;
  Scene scene = make_scene(soup, labels);
  smooth_borders(scene);
  const Viewpoint viewpoint = options.viewpoint ? *options.viewpoint
                                                : choose_viewpoint(scene, options.up);
  const std::size_t samples = (std::max<std::size_t>)(options.samples, 1);
  Sample_buffer buffer(options.width * samples, options.height * samples);
  const Projection projection(scene, viewpoint, double(buffer.width()), double(buffer.height()),
                              margin);
  draw_lit_faces(scene, projection, viewpoint, buffer);

  // Widths follow the size of the picture: 2 pixels for borders at a height of 600.
  const double line = double(samples) * std::sqrt(double(options.height) / 600);
  draw_borders(scene, (std::max)(1.0, 0.85 * line), buffer);
  return resolve(scene, buffer, options, samples);
}

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
