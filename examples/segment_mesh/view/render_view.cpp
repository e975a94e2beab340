// SPDX-License-Identifier: GPL-3.0-or-later

#include "view/render_view.h"

#include "soup/vector_algebra.h"
#include "view/Sample_buffer.h"
#include "view/Scene.h"
#include "view/choose_viewpoint.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace segment_mesh {

namespace {

double length(const Point& v)
{
  return std::sqrt(inner_product(v, v));
}

/// The normals at the corners of faces: the surface looks smooth, but for edges that are sharp.
class Corner_normals
{
public:
  explicit Corner_normals(const Scene& scene)
    : m_scene(scene)
    , m_starts(scene.points.size() + 2)
    , m_faces(scene.corners.size())
  {
    // m_starts[p + 2] counts the faces of p, then holds their end; filling moves m_starts[p + 1]
    // from the start of p to its end, which is the start of the next one.
    for (Scene::Index p : scene.corners)
      ++m_starts[p + 2];
    for (std::size_t i = 2; i < m_starts.size(); ++i)
      m_starts[i] += m_starts[i - 1];
    for (std::size_t f = 0; f < scene.number_of_faces(); ++f)
      for (Scene::Index c = scene.first_corners[f]; c < scene.first_corners[f + 1]; ++c)
        m_faces[m_starts[scene.corners[c] + 1]++] = Scene::Index(f);
  }

  /// A unit vector, or zero: the mean, by area, of the normals round the corner that are near that
  /// of the face. The normal of a sliver may be arbitrary: unless another face has it, too, that of
  /// the largest face at the corner takes its place.
  Point operator()(std::size_t face, Scene::Index corner) const
  {
    constexpr std::size_t many = 64; // a fan of n faces would take n * n steps
    constexpr double thin = 0.02, small = 0.1;
    const std::size_t point = m_scene.corners[corner];
    const Point& own = m_scene.area_vectors[face];
    if (m_starts[point + 1] - m_starts[point] > many)
      return unit_vector(own);
    Point sum = sum_near(own, point);
    const double side = longest_side(face, point), area = length(own);
    if (area < thin * side * side && length(sum) < 2 * area) {
      const Point& largest = m_scene.area_vectors[largest_face(point)];
      if (area < small * length(largest))
        sum = sum_near(largest, point);
    }
    return unit_vector(sum);
  }

private:
  /// The sum of the area vectors round a point that are near a direction, turned to its side,
  /// should they be turned the wrong way.
  Point sum_near(const Point& direction, std::size_t point) const
  {
    constexpr double cosine_of_sharp = 0.77; // 40 degrees
    const Point normal = unit_vector(direction);
    Point sum = {0, 0, 0};
    for (Scene::Index i = m_starts[point]; i < m_starts[point + 1]; ++i) {
      const Point& vector = m_scene.area_vectors[m_faces[i]];
      const double along = inner_product(normal, vector);
      if (std::abs(along) > cosine_of_sharp * length(vector))
        sum = plus(sum, times(along < 0 ? -1 : 1, vector));
    }
    return sum;
  }

  Scene::Index largest_face(std::size_t point) const
  {
    return *std::max_element(
      m_faces.begin() + std::ptrdiff_t(m_starts[point]),
      m_faces.begin() + std::ptrdiff_t(m_starts[point + 1]), [&](Scene::Index f, Scene::Index g) {
        return length(m_scene.area_vectors[f]) < length(m_scene.area_vectors[g]);
      });
  }

  /// Of those of a face that leave one of its points.
  double longest_side(std::size_t face, std::size_t point) const
  {
    double longest = 0;
    for (Scene::Index c = m_scene.first_corners[face]; c < m_scene.first_corners[face + 1]; ++c)
      longest = (std::max)(
        longest, length(minus(m_scene.points[m_scene.corners[c]], m_scene.points[point])));
    return longest;
  }

  const Scene& m_scene;
  std::vector<Scene::Index> m_starts, m_faces; // the faces round each point, in their order
};

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
  const Corner_normals normal(scene);
  const Lamp lamp(viewpoint);
  std::vector<float> light;
  for (std::size_t f = 0; f < scene.number_of_faces(); ++f)
    for (Scene::Index c = scene.first_corners[f]; c < scene.first_corners[f + 1]; ++c)
      light.push_back(float(lamp(normal(f, c))));
  draw_faces(
    scene, projection, [&](Scene::Index c) { return double(light[c]); }, buffer);
}

/// The dark lines on a picture: how much of a sample's color they take, from 0 to 255. None is on
/// the background. Radii are in samples.
class Ink
{
public:
  explicit Ink(const Sample_buffer& buffer)
    : m_buffer(buffer)
    , m_darkness(buffer.width() * buffer.height())
  {}

  std::uint8_t darkness(std::size_t sample) const { return m_darkness[sample]; }

  /// Where two neighboring samples show different segments: borders, and outlines of one segment
  /// before another.
  void draw_borders(const Scene& scene, double radius, std::uint8_t darkness)
  {
    const auto differ = [&](std::size_t i, std::size_t j) {
      const Sample_buffer::Index f = m_buffer.face(i), g = m_buffer.face(j);
      return f != g && f != Sample_buffer::no_face && g != Sample_buffer::no_face &&
             scene.labels[f] != scene.labels[g];
    };
    const std::size_t width = m_buffer.width();
    for (std::size_t y = 0; y < m_buffer.height(); ++y)
      for (std::size_t x = 0; x < width; ++x) {
        const std::size_t i = y * width + x;
        if ((x + 1 < width && differ(i, i + 1)) ||
            (y + 1 < m_buffer.height() && differ(i, i + width)))
          stamp(x, y, radius, darkness);
      }
  }

  /// Lines on the surface, where no face is before them.
  void draw_edges(const Scene& scene, const Projection& projection,
                  const std::vector<Vertex_pair>& edges, double radius, std::uint8_t darkness)
  {
    const auto is_there = [&](std::size_t i) {
      return i < scene.points.size() && scene.is_used[i];
    };
    for (const Vertex_pair& edge : edges)
      if (is_there(edge[0]) && is_there(edge[1]))
        draw_line(projection(scene.points[edge[0]]), projection(scene.points[edge[1]]), radius,
                  darkness);
  }

private:
  void draw_line(const Screen_point& from, const Screen_point& to, double radius,
                 std::uint8_t darkness)
  {
    const double steps = std::ceil((std::max)(std::abs(to.x - from.x), std::abs(to.y - from.y))) +
                         1;
    for (double i = 0; i <= steps; ++i) {
      const double t = i / steps;
      const double x = from.x + t * (to.x - from.x), y = from.y + t * (to.y - from.y);
      if (x >= 0 && y >= 0 && x < double(m_buffer.width()) && y < double(m_buffer.height()) &&
          is_visible(std::size_t(x), std::size_t(y), from.depth + t * (to.depth - from.depth)))
        stamp(std::size_t(x), std::size_t(y), radius, darkness);
    }
  }

  /// A line lies on the surface, whose depth varies within a sample: the deepest of the samples
  /// around is taken for the surface.
  bool is_visible(std::size_t x, std::size_t y, double depth) const
  {
    constexpr float tolerance = 1e-3f; // of the radius of the scene
    bool is_visible = false;
    for_each_near(x, y, 1.5, [&](std::size_t sample) {
      is_visible |= float(depth) <= m_buffer.depth(sample) + tolerance;
    });
    return is_visible;
  }

  void stamp(std::size_t x, std::size_t y, double radius, std::uint8_t darkness)
  {
    for_each_near(x, y, radius, [&](std::size_t sample) {
      m_darkness[sample] = (std::max)(m_darkness[sample], darkness);
    });
  }

  /// Calls `f` for the samples within a distance of (x, y) that are not background.
  template <typename Function>
  void for_each_near(std::size_t x, std::size_t y, double distance, const Function& f) const
  {
    const std::ptrdiff_t reach = std::ptrdiff_t(distance);
    for (std::ptrdiff_t dy = -reach; dy <= reach; ++dy)
      for (std::ptrdiff_t dx = -reach; dx <= reach; ++dx) {
        const std::size_t column = x + std::size_t(dx), row = y + std::size_t(dy);
        if (double(dx * dx + dy * dy) > distance * distance || column >= m_buffer.width() ||
            row >= m_buffer.height()) // also what is before the first one
          continue;
        const std::size_t sample = row * m_buffer.width() + column;
        if (m_buffer.face(sample) != Sample_buffer::no_face)
          f(sample);
      }
  }

  const Sample_buffer& m_buffer;
  std::vector<std::uint8_t> m_darkness;
};

/// Adds what a sample shows to channels from 0 to 255: toward black below a light of 1, toward
/// white above.
void add_sample(const Color& color, float light, float paint, std::array<float, 3>& sum)
{
  const float glow = (std::min)((std::max)(light - 1, 0.0f), 1.0f);
  for (std::size_t j = 0; j < 3; ++j)
    sum[j] += paint * ((std::min)(light, 1.0f) * color[j] + glow * float(255 - color[j]));
}

/// Each pixel is the mean of its samples.
Image resolve(const Scene& scene, const Sample_buffer& buffer, const Ink& ink,
              const View_options& options, std::size_t samples)
{
  Image image(options.width, options.height, options.background);
  for (std::size_t y = 0; y < image.height; ++y)
    for (std::size_t x = 0; x < image.width; ++x) {
      std::array<float, 3> sum = {0, 0, 0};
      for (std::size_t row = y * samples; row < (y + 1) * samples; ++row)
        for (std::size_t column = x * samples; column < (x + 1) * samples; ++column) {
          const std::size_t sample = row * buffer.width() + column;
          if (buffer.face(sample) == Sample_buffer::no_face) {
            add_sample(options.background, 1, 1, sum);
            continue;
          }
          const std::size_t label = scene.labels[buffer.face(sample)];
          add_sample(segment_color(label < options.colors.size() ? options.colors[label] : label),
                     buffer.light(sample), 1 - float(ink.darkness(sample)) / 255, sum);
        }
      for (std::size_t j = 0; j < 3; ++j)
        image.at(x, y)[j] = std::uint8_t(sum[j] / float(samples * samples) + 0.5f);
    }
  return image;
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
  const Viewpoint viewpoint = options.viewpoint ? *options.viewpoint
                                                : choose_viewpoint(scene, options.up);
  const std::size_t samples = (std::max<std::size_t>)(options.samples, 1);
  Sample_buffer buffer(options.width * samples, options.height * samples);
  const Projection projection(scene, viewpoint, double(buffer.width()), double(buffer.height()),
                              margin);
  draw_lit_faces(scene, projection, viewpoint, buffer);

  // Widths follow the size of the picture: 2 pixels for borders at a height of 600.
  const double line = double(samples) * std::sqrt(double(options.height) / 600);
  Ink ink(buffer);
  ink.draw_edges(scene, projection, feature_edges, 0.6 * line, 130);
  ink.draw_borders(scene, (std::max)(1.0, 0.85 * line), 215);
  ink.draw_edges(scene, projection, options.marked_edges, 1.3 * line, 255);
  return resolve(scene, buffer, ink, options, samples);
}

} // namespace segment_mesh
