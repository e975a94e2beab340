// SPDX-License-Identifier: GPL-3.0-or-later

#include "view/Sample_buffer.h"

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
  , m_blocks_of_row((width + samples_of_block - 1) / samples_of_block)
  , m_faces(width * height, Index(no_face))
  , m_depths(width * height, std::numeric_limits<float>::infinity())
  , m_farthest(m_blocks_of_row * height, std::numeric_limits<float>::infinity())
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
  constexpr std::size_t worth_a_bound = 16; // samples: finding the bound of a block takes a while
  const std::size_t end = first_sample(to.x, m_width);
  const double step = to.x > from.x ? 1 / (to.x - from.x) : 0;
  const auto position = [&](std::size_t column) { return (double(column) + 0.5 - from.x) * step; };
  const auto depth_at = [&](double t) { return float(from.depth + t * (to.depth - from.depth)); };
  for (std::size_t column = first_sample(from.x, m_width); column < end;) {
    const std::size_t block = column / samples_of_block, first = column;
    const std::size_t last = (std::min)(end, (block + 1) * samples_of_block);
    // Depths rise or fall along a span, also when they are rounded.
    const float nearest = (std::min)(depth_at(position(first)), depth_at(position(last - 1)));
    if (nearest > m_farthest[row * m_blocks_of_row + block]) {
      column = last;
      continue;
    }
    for (; column < last; ++column) {
      const double t = position(column);
      const float depth = depth_at(t);
      const std::size_t sample = row * m_width + column;
      if (depth < m_depths[sample] || (depth == m_depths[sample] && face < m_faces[sample])) {
        m_depths[sample] = depth;
        m_lights[sample] = float(from.light + t * (to.light - from.light));
        m_faces[sample] = face;
      }
    }
    if (last - first >= worth_a_bound)
      bound_block(row, block);
  }
}

void Sample_buffer::bound_block(std::size_t row, std::size_t block)
{
  const auto begin = m_depths.begin() + std::ptrdiff_t(row * m_width + block * samples_of_block);
  const std::size_t size = (std::min)(m_width - block * samples_of_block, samples_of_block);
  m_farthest[row * m_blocks_of_row + block] = *std::max_element(begin,
                                                                begin + std::ptrdiff_t(size));
}

} // namespace segment_mesh
