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

Screen_point between(const Screen_point& from, const Screen_point& to, double t)
{
  return {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y),
          from.depth + t * (to.depth - from.depth), from.light + t * (to.light - from.light)};
}

} // namespace

Sample_buffer::Sample_buffer(std::size_t width, std::size_t height)
  : m_width(width)
  , m_height(height)
  , m_samples(width * height)
{}

void Sample_buffer::draw_polygon(const std::vector<Screen_point>& corners, Index face)
{
  const auto [low, high] = std::minmax_element(
    corners.begin(), corners.end(),
    [](const Screen_point& a, const Screen_point& b) { return a.y < b.y; });
  const std::size_t end = first_sample(high->y, m_height);
  for (std::size_t row = first_sample(low->y, m_height); row < end; ++row) {
    find_crossings(corners, double(row) + 0.5);
    for (std::size_t i = 0; i + 1 < m_crossings.size(); i += 2)
      draw_span(m_crossings[i], m_crossings[i + 1], row, face);
  }
}

void Sample_buffer::find_crossings(const std::vector<Screen_point>& corners, double y)
{
  m_crossings.clear();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Screen_point* from = &corners[i];
    const Screen_point* to = &corners[i + 1 < corners.size() ? i + 1 : 0];
    if ((from->y <= y) == (to->y <= y))
      continue;
    if (from->y > to->y) // both faces of a side compute the same bits
      std::swap(from, to);
    m_crossings.push_back(between(*from, *to, (y - from->y) / (to->y - from->y)));
  }
  std::sort(m_crossings.begin(), m_crossings.end(),
            [](const Screen_point& a, const Screen_point& b) { return a.x < b.x; });
}

void Sample_buffer::draw_span(const Screen_point& from, const Screen_point& to, std::size_t row,
                              Index face)
{
  const std::size_t end = first_sample(to.x, m_width);
  const double step = to.x > from.x ? 1 / (to.x - from.x) : 0;
  for (std::size_t column = first_sample(from.x, m_width); column < end; ++column) {
    const Screen_point p = between(from, to, (double(column) + 0.5 - from.x) * step);
    Sample& sample = m_samples[row * m_width + column];
    if (float(p.depth) < sample.depth || (float(p.depth) == sample.depth && face < sample.face))
      sample = {face, float(p.depth), float(p.light), false};
  }
}

Projection::Projection(const Scene& scene, const Viewpoint& viewpoint, double width, double height,
                       double margin)
  : Projection(viewpoint, width, height, 1)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low_x = infinity, low_y = infinity, high_x = -infinity, high_y = -infinity;
  for (const std::size_t i : scene.soup.polygons.corners()) {
    const double x = inner_product(scene.soup.points[i], viewpoint.right);
    const double y = -inner_product(scene.soup.points[i], viewpoint.up);
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

Screen_point Projection::operator()(const Point& p, double light) const
{
  return {m_offset_x + m_scale * inner_product(p, m_viewpoint.right),
          m_offset_y - m_scale * inner_product(p, m_viewpoint.up),
          -inner_product(p, m_viewpoint.toward_viewer), light};
}

} // namespace segment_mesh
