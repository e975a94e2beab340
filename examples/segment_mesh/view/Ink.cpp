// SPDX-License-Identifier: GPL-3.0-or-later

#include "view/Ink.h"

#include <algorithm>
#include <cmath>

namespace segment_mesh {

std::vector<Ink::Offset> Ink::disc(double radius)
{
  std::vector<Offset> result;
  const std::ptrdiff_t reach = std::ptrdiff_t(radius);
  for (std::ptrdiff_t y = -reach; y <= reach; ++y)
    for (std::ptrdiff_t x = -reach; x <= reach; ++x)
      if (double(x * x + y * y) <= radius * radius)
        result.push_back({x, y});
  return result;
}

void Ink::stamp(std::size_t x, std::size_t y, const std::vector<Offset>& disc,
                std::uint8_t darkness)
{
  for (const Offset& offset : disc) {
    const std::size_t column = x + std::size_t(offset.x), row = y + std::size_t(offset.y);
    if (column >= m_buffer.width() || row >= m_buffer.height()) // also what is before the first one
      continue;
    const std::size_t sample = row * m_buffer.width() + column;
    if (m_buffer.face(sample) != Sample_buffer::no_face)
      m_darkness[sample] = (std::max)(m_darkness[sample], darkness);
  }
}

void Ink::draw_borders(const Scene& scene, double radius, std::uint8_t darkness)
{
  const std::vector<Offset> round = disc(radius);
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
        stamp(x, y, round, darkness);
    }
}

/// A line lies on the surface, whose depth varies within a sample: the deepest of the samples
/// around is taken for the surface.
bool Ink::is_visible(std::size_t x, std::size_t y, double depth) const
{
  constexpr float tolerance = 1e-3f; // of the radius of the scene
  for (std::size_t row = y > 0 ? y - 1 : 0; row <= y + 1 && row < m_buffer.height(); ++row)
    for (std::size_t column = x > 0 ? x - 1 : 0; column <= x + 1 && column < m_buffer.width();
         ++column) {
      const std::size_t sample = row * m_buffer.width() + column;
      if (m_buffer.face(sample) != Sample_buffer::no_face &&
          float(depth) <= m_buffer.depth(sample) + tolerance)
        return true;
    }
  return false;
}

void Ink::draw_line(const Screen_point& from, const Screen_point& to,
                    const std::vector<Offset>& disc, std::uint8_t darkness)
{
  const double length = (std::max)(std::abs(to.x - from.x), std::abs(to.y - from.y));
  const std::size_t steps = std::size_t(std::ceil(length)) + 1;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double t = double(i) / double(steps);
    const double x = from.x + t * (to.x - from.x), y = from.y + t * (to.y - from.y);
    if (!(x >= 0 && y >= 0 && x < double(m_buffer.width()) && y < double(m_buffer.height())))
      continue;
    if (is_visible(std::size_t(x), std::size_t(y), from.depth + t * (to.depth - from.depth)))
      stamp(std::size_t(x), std::size_t(y), disc, darkness);
  }
}

void Ink::draw_edges(const Scene& scene, const Projection& projection,
                     const std::vector<Vertex_pair>& edges, double radius, std::uint8_t darkness)
{
  const std::vector<Offset> round = disc(radius);
  const auto is_there = [&](std::size_t i) { return i < scene.points.size() && scene.is_used[i]; };
  for (const Vertex_pair& edge : edges)
    if (is_there(edge[0]) && is_there(edge[1]))
      draw_line(projection(scene.points[edge[0]]), projection(scene.points[edge[1]]), round,
                darkness);
}

} // namespace segment_mesh
