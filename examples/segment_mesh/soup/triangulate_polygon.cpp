// SPDX-License-Identifier: LGPL-3.0-or-later

#include "soup/triangulate_polygon.h"

#include "soup/vector_algebra.h"

#include <algorithm>

namespace segment_mesh {

namespace {

class Ear_clipping
{
public:
  Ear_clipping(std::vector<Point> corners, Point normal)
    : m_corners(std::move(corners))
    , m_normal(normal)
  {
    for (std::size_t i = 0; i < m_corners.size(); ++i)
      m_rest.push_back(i);
  }

  /// Removes an ear: its corners. The tip of the last triangle is tried last, so that ears do not
  /// gather at one corner.
  std::array<std::size_t, 3> clip()
  {
    constexpr std::size_t many = 1000;
    const std::size_t n = m_rest.size();
    std::size_t tip = n;
    for (std::size_t i = 0; i < n && n <= many && tip == n; ++i)
      if (is_ear((m_start + i) % n))
        tip = (m_start + i) % n;
    tip = tip == n ? 1 : tip;
    const std::array<std::size_t, 3> ear = {before(tip), m_rest[tip], after(tip)};
    m_rest.erase(m_rest.begin() + std::ptrdiff_t(tip));
    m_start = tip % m_rest.size();
    return ear;
  }

  std::size_t size() const { return m_rest.size(); }

private:
  std::size_t before(std::size_t i) const
  {
    return m_rest[(i + m_rest.size() - 1) % m_rest.size()];
  }
  std::size_t after(std::size_t i) const { return m_rest[(i + 1) % m_rest.size()]; }

  /// Positive if a turn from a over b to c is to the left, seen from the tip of the normal.
  double turn(std::size_t a, std::size_t b, std::size_t c) const
  {
    return inner_product(m_normal, cross_product(minus(m_corners[b], m_corners[a]),
                                                 minus(m_corners[c], m_corners[a])));
  }

  bool is_ear(std::size_t i) const
  {
    const std::size_t a = before(i), b = m_rest[i], c = after(i);
    if (turn(a, b, c) <= 0)
      return false;
    const auto is_at = [&](std::size_t p, std::size_t q) { return m_corners[p] == m_corners[q]; };
    return std::none_of(m_rest.begin(), m_rest.end(), [&](std::size_t p) {
      return !is_at(p, a) && !is_at(p, b) && !is_at(p, c) && turn(a, b, p) >= 0 &&
             turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    });
  }

  std::vector<Point> m_corners;
  Point m_normal;
  std::vector<std::size_t> m_rest; // the corners that are left
  std::size_t m_start = 0;         // where the next ear is looked for
};

} // namespace

void triangulate_polygon(const std::vector<Point>& points, const Polygon_soup::Polygon& polygon,
                         Triangles& triangles)
{
  if (polygon.size() == 3) {
    triangles.push_back({polygon[0], polygon[1], polygon[2]});
    return;
  }
  std::vector<Point> corners;
  for (std::size_t v : polygon)
    corners.push_back(points[v]);
  const Point normal = unit_vector(area_vector(points, polygon));
  Ear_clipping clipping(std::move(corners), normal);
  while (clipping.size() > 2) {
    const auto [a, b, c] = clipping.clip();
    triangles.push_back({polygon[a], polygon[b], polygon[c]});
  }
}

} // namespace segment_mesh
