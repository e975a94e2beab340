// SPDX-License-Identifier: GPL-3.0-or-later

#include "view/Sample_buffer.h"

#include "soup/vector_algebra.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace segment_mesh {

namespace {

/// The first of `size` samples whose center is at or behind a coordinate.
std::size_t first_sample(double coordinate, std::size_t size)
{
  const double first = std::ceil(coordinate - 0.5);
  return first <= 0 ? 0 : std::size_t((std::min)(first, double(size)));
}

} // namespace

Sample_buffer::Sample_buffer(std::size_t width, std::size_t height)
  : m_width(width)
  , m_height(height)
  , m_faces(width * height, Index(no_face))
  , m_depths(width * height, std::numeric_limits<float>::infinity())
  , m_lights(width * height)
{}

void Sample_buffer::draw_polygon(const std::vector<Corner>& corners, Index face)
{
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Corner& c : corners) {
    low = (std::min)(low, c.y);
    high = (std::max)(high, c.y);
  }
  const std::size_t end = first_sample(high, m_height);
  for (std::size_t row = first_sample(low, m_height); row < end; ++row) {
    find_crossings(corners, double(row) + 0.5);
    for (std::size_t i = 0; i + 1 < m_crossings.size(); i += 2)
      draw_span(m_crossings[i], m_crossings[i + 1], row, face);
  }
}

void Sample_buffer::find_crossings(const std::vector<Corner>& corners, double y)
{
  m_crossings.clear();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner* from = &corners[i];
    const Corner* to = &corners[i + 1 < corners.size() ? i + 1 : 0];
    if ((from->y <= y) == (to->y <= y))
      continue;
    if (from->y > to->y) // both faces of a side compute the same bits
      std::swap(from, to);
    const double t = (y - from->y) / (to->y - from->y);
    m_crossings.push_back({from->x + t * (to->x - from->x),
                           from->depth + t * (to->depth - from->depth),
                           from->light + t * (to->light - from->light)});
  }
  std::sort(m_crossings.begin(), m_crossings.end(),
            [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
}

void Sample_buffer::draw_span(const Crossing& from, const Crossing& to, std::size_t row, Index face)
{
  const std::size_t end = first_sample(to.x, m_width);
  const double step = to.x > from.x ? 1 / (to.x - from.x) : 0;
  for (std::size_t column = first_sample(from.x, m_width); column < end; ++column) {
    const double t = (double(column) + 0.5 - from.x) * step;
    const float depth = float(from.depth + t * (to.depth - from.depth));
    const std::size_t sample = row * m_width + column;
    if (depth < m_depths[sample] || (depth == m_depths[sample] && face < m_faces[sample])) {
      m_depths[sample] = depth;
      m_lights[sample] = float(from.light + t * (to.light - from.light));
      m_faces[sample] = face;
    }
  }
}

Projection::Projection(const Scene& scene, const Viewpoint& viewpoint, double width, double height,
                       double margin)
  : Projection(viewpoint, width, height, 1)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low_x = infinity, low_y = infinity, high_x = -infinity, high_y = -infinity;
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    if (!scene.is_used[i])
      continue;
    const double x = inner_product(scene.points[i], viewpoint.right);
    const double y = -inner_product(scene.points[i], viewpoint.up);
    low_x = (std::min)(low_x, x);
    low_y = (std::min)(low_y, y);
    high_x = (std::max)(high_x, x);
    high_y = (std::max)(high_y, y);
  }
  if (!(high_x > low_x) && !(high_y > low_y)) // nothing, or a point
    return;
  const double room = 1 - 2 * margin;
  m_scale = room * (std::min)(width / (high_x - low_x), height / (high_y - low_y));
  m_offset_x = width / 2 - m_scale * (low_x + high_x) / 2;
  m_offset_y = height / 2 - m_scale * (low_y + high_y) / 2;
}

Screen_point Projection::operator()(const Point& p) const
{
  return {m_offset_x + m_scale * inner_product(p, m_viewpoint.right),
          m_offset_y - m_scale * inner_product(p, m_viewpoint.up),
          -inner_product(p, m_viewpoint.toward_viewer)};
}

} // namespace segment_mesh
