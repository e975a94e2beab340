// SPDX-License-Identifier: GPL-3.0-or-later

#include "models/Surface_relaxation.h"

#include "soup/vector_algebra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace segment_mesh {

namespace {

using Halfedge = std::array<std::size_t, 2>; // from a point to a point

double cotangent(const Point& at, const Point& p, const Point& q)
{
  const Point u = minus(p, at), v = minus(q, at), normal = cross_product(u, v);
  return inner_product(u, v) / std::sqrt((std::max)(inner_product(normal, normal), 1e-300));
}

Point area_vector(const Point& p, const Point& q, const Point& r)
{
  return cross_product(minus(q, p), minus(r, p));
}

} // namespace

Surface_relaxation::Surface_relaxation(const Implicit_shape& shape, Polygon_soup& soup,
                                       double edge_length)
  : m_shape(shape)
  , m_soup(soup)
  , m_edge_length(edge_length)
{}

//        c             c
//      / | \         /   \      .
//     a  |  b  ->   a-----b
//      \ | /         \   /
//        d             d
void Surface_relaxation::flip_edges()
{
  std::map<Halfedge, std::size_t> face_of;
  for (std::size_t f = 0; f < m_soup.polygons.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      face_of[{m_soup.polygons[f][i], m_soup.polygons[f][(i + 1) % 3]}] = f;
  const auto opposite = [this](std::size_t face, std::size_t p, std::size_t q) {
    const Polygon_soup::Polygon triangle = m_soup.polygons[face];
    return std::size_t(*std::find_if(triangle.begin(), triangle.end(),
                                     [=](std::size_t r) { return r != p && r != q; }));
  };
  std::vector<bool> is_new(m_soup.polygons.size());
  for (const auto& [edge, face] : std::map<Halfedge, std::size_t>(face_of)) {
    const auto [d, c] = edge;
    const std::size_t twin = face_of.at({c, d});
    if (d > c || is_new[face] || is_new[twin])
      continue;
    const std::size_t a = opposite(face, c, d), b = opposite(twin, c, d);
    const Point &pa = m_soup.points[a], &pb = m_soup.points[b], &pc = m_soup.points[c],
                &pd = m_soup.points[d];
    const bool is_delaunay = cotangent(pa, pc, pd) + cotangent(pb, pc, pd) >= 0;
    const Point old_normal = plus(area_vector(pa, pd, pc), area_vector(pb, pc, pd));
    const bool is_fold = inner_product(area_vector(pa, pd, pb), old_normal) <= 0 ||
                         inner_product(area_vector(pa, pb, pc), old_normal) <= 0;
    if (is_delaunay || is_fold || face_of.count({a, b}) + face_of.count({b, a}) > 0)
      continue;
    m_soup.polygons.replace(face, {a, d, b});
    m_soup.polygons.replace(twin, {a, b, c});
    is_new[face] = is_new[twin] = true;
    face_of[{a, b}] = twin;
  }
}

void Surface_relaxation::move_points()
{
  std::vector<Point> sums(m_soup.points.size(), Point{0, 0, 0});
  std::vector<std::size_t> degrees(m_soup.points.size());
  for (const Polygon_soup::Polygon& triangle : m_soup.polygons)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t p = triangle[i];
      sums[p] = plus(sums[p], m_soup.points[triangle[(i + 1) % 3]]);
      ++degrees[p];
    }
  for (std::size_t p = 0; p < sums.size(); ++p)
    m_soup.points[p] = projected(times(1 / double(degrees[p]), sums[p]));
}

/// Newton's method along the gradient, by central differences.
Point Surface_relaxation::projected(Point p) const
{
  const int number_of_steps = 3;
  const double difference = 1e-4 * m_edge_length, longest_step = m_edge_length / 2;
  for (int step = 0; step < number_of_steps; ++step) {
    Point gradient;
    for (std::size_t i = 0; i < 3; ++i) {
      Point before = p, after = p;
      before[i] -= difference;
      after[i] += difference;
      gradient[i] = (m_shape(after) - m_shape(before)) / (2 * difference);
    }
    const double squared = inner_product(gradient, gradient);
    if (squared == 0)
      break;
    const double wanted = -m_shape(p) / squared, limit = longest_step / std::sqrt(squared);
    p = plus(p, times((std::max)(-limit, (std::min)(limit, wanted)), gradient));
  }
  return p;
}

} // namespace segment_mesh
