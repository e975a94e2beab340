// SPDX-License-Identifier: GPL-3.0-or-later

#include "view/render_view.h"

#include "view/Ink.h"
#include "view/Projection.h"
#include "view/Sample_buffer.h"
#include "view/Scene.h"
#include "view/choose_viewpoint.h"
#include "view/draw_faces.h"
#include "view/light_corners.h"

#include <algorithm>
#include <cmath>

namespace segment_mesh {

namespace {

/// A channel of a color in light: toward black below 1, toward white above.
float lit(float channel, float light)
{
  return light <= 1 ? channel * light : channel + (255 - channel) * (std::min)(light - 1, 1.0f);
}

/// What the samples show. Channels from 0 to 255.
class Shading
{
public:
  Shading(const Scene& scene, const Sample_buffer& buffer, const Ink& ink,
          const View_options& options)
    : m_buffer(buffer)
    , m_ink(ink)
    , m_background(options.background)
  {
    m_colors.reserve(scene.number_of_faces());
    for (std::size_t label : scene.labels)
      m_colors.push_back(
        segment_color(label < options.colors.size() ? options.colors[label] : label));
  }

  std::array<float, 3> operator()(std::size_t sample) const
  {
    const Sample_buffer::Index face = m_buffer.face(sample);
    if (face == Sample_buffer::no_face)
      return {float(m_background[0]), float(m_background[1]), float(m_background[2])};
    const float light = m_buffer.light(sample);
    const float paint = 1 - float(m_ink.darkness(sample)) / 255;
    std::array<float, 3> result;
    for (std::size_t j = 0; j < 3; ++j)
      result[j] = paint * lit(m_colors[face][j], light);
    return result;
  }

private:
  const Sample_buffer& m_buffer;
  const Ink& m_ink;
  Color m_background;
  std::vector<Color> m_colors; // of each face
};

/// Each pixel is the mean of its samples.
void resolve(const Shading& shading, std::size_t samples, Image& image)
{
  const std::size_t width = image.width * samples;
  const float weight = 1 / float(samples * samples);
  for (std::size_t y = 0; y < image.height; ++y)
    for (std::size_t x = 0; x < image.width; ++x) {
      std::array<float, 3> sum = {0, 0, 0};
      for (std::size_t row = y * samples; row < (y + 1) * samples; ++row)
        for (std::size_t column = x * samples; column < (x + 1) * samples; ++column) {
          const std::array<float, 3> color = shading(row * width + column);
          for (std::size_t j = 0; j < 3; ++j)
            sum[j] += color[j];
        }
      for (std::size_t j = 0; j < 3; ++j)
        image.at(x, y)[j] = std::uint8_t(sum[j] * weight + 0.5f);
    }
}

} // namespace

std::vector<Vertex_pair> edges_of_lines(const std::vector<std::vector<std::size_t>>& lines)
{
  std::vector<Vertex_pair> edges;
  for (const std::vector<std::size_t>& line : lines)
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      edges.push_back({line[i], line[i + 1]});
  return edges;
}

Image render_view(const Polygon_soup& soup, const std::vector<std::size_t>& labels,
                  const std::vector<Vertex_pair>& feature_edges, const View_options& options)
{
  constexpr double margin = 0.04;
  const Scene scene = make_scene(soup, labels);
  const Viewpoint viewpoint = options.viewpoint ? *options.viewpoint : choose_viewpoint(scene);
  const std::size_t samples = (std::max<std::size_t>)(options.samples, 1);
  Sample_buffer buffer(options.width * samples, options.height * samples);
  const Projection projection(scene, viewpoint, double(buffer.width()), double(buffer.height()),
                              margin);
  const std::vector<float> light = light_corners(scene, viewpoint);
  draw_faces(
    scene, projection, [&light](Scene::Index c) { return double(light[c]); }, buffer);

  // Widths follow the size of the picture: 2 pixels for borders at a height of 600.
  const double line = double(samples) * std::sqrt(double(options.height) / 600);
  Ink ink(buffer);
  ink.draw_edges(scene, projection, feature_edges, 0.6 * line, 130);
  ink.draw_borders(scene, (std::max)(1.0, 0.85 * line), 215);
  ink.draw_edges(scene, projection, options.marked_edges, 1.3 * line, 255);

  Image image(options.width, options.height, options.background);
  resolve(Shading(scene, buffer, ink, options), samples, image);
  return image;
}

} // namespace segment_mesh
