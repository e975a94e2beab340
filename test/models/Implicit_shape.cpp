// SPDX-License-Identifier: GPL-3.0-or-later

#include "models/Implicit_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace segment_mesh {

namespace {

Point difference(const Point& p, const Point& q)
{
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

double dot(const Point& v, const Point& w)
{
  return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
}

} // namespace

// The implicit function k divided by the length of its gradient, up to a factor: a distance to
// first order near the surface. k is 1 on the ellipsoid, gradient_k the length of its gradient
// times k.
Distance ellipsoid(const Point& a, const Point& b, double radius)
{
  const Point center = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
  const Point half_axis = difference(b, center);
  const double half_length = std::sqrt(dot(half_axis, half_axis));
  return [=](const Point& p) {
    const Point v = difference(p, center);
    const double along = dot(v, half_axis) / half_length;
    const double across = std::sqrt((std::max)(0.0, dot(v, v) - along * along));
    const double k = std::hypot(along / half_length, across / radius);
    const double gradient_k = std::hypot(along / (half_length * half_length),
                                         across / (radius * radius));
    return gradient_k > 0 ? k * (k - 1) / gradient_k : -(std::min)(half_length, radius);
  };
}

void Implicit_shape::add(Distance body, std::size_t part)
{
  m_bodies.push_back({std::move(body), part});
  m_number_of_parts = (std::max)(m_number_of_parts, part + 1);
}

// The quadratic smooth minimum: the least distance, lowered by up to blend / 4 where two are equal.
double Implicit_shape::operator()(const Point& p) const
{
  double result = (std::numeric_limits<double>::max)();
  for (const Body& body : m_bodies) {
    const double d = body.distance(p);
    const double overlap = (std::max)(0.0, m_blend - std::abs(result - d));
    result = (std::min)(result, d);
    if (overlap > 0)
      result -= overlap * overlap / (4 * m_blend);
  }
  return result;
}

std::size_t Implicit_shape::part_at(const Point& p) const
{
  const Body* nearest = nullptr;
  double least = 0;
  for (const Body& body : m_bodies) {
    const double d = body.distance(p);
    if (nearest == nullptr || d < least) {
      nearest = &body;
      least = d;
    }
  }
  return nearest == nullptr ? 0 : nearest->part;
}

namespace {

/// The neighbor of each triangle across each of its edges.
std::vector<std::array<std::size_t, 3>> neighbors(const Polygons& triangles)
{
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> face_of_halfedge;
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      face_of_halfedge[{triangles[f][i], triangles[f][(i + 1) % 3]}] = f;
  std::vector<std::array<std::size_t, 3>> result(triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      result[f][i] = face_of_halfedge.at({triangles[f][(i + 1) % 3], triangles[f][i]});
  return result;
}

/// Gives a triangle the label of two of its neighbors, until there is none whose own is another
/// one: no part has an island of a triangle or two beyond its border. Each step shortens the
/// borders, so it ends.
void smooth_labels(const Polygons& triangles, std::vector<std::size_t>& labels)
{
  const std::vector<std::array<std::size_t, 3>> neighbors_of = neighbors(triangles);
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      const std::size_t a = labels[neighbors_of[f][0]], b = labels[neighbors_of[f][1]],
                        c = labels[neighbors_of[f][2]];
      const std::size_t majority = a == b || a == c ? a : b == c ? b : labels[f];
      has_changed = has_changed || majority != labels[f];
      labels[f] = majority;
    }
  }
}

} // namespace

Labelled_model make_labelled_model(const Implicit_shape& shape, const Point& inside,
                                   double edge_length)
{
  Labelled_model model;
  model.soup = mesh_implicit_shape(shape, inside, edge_length);
  model.number_of_parts = shape.number_of_parts();
  for (const Polygon_soup::Polygon& polygon : model.soup.polygons)
    model.labels.push_back(shape.part_at(centroid(model.soup, polygon)));
  smooth_labels(model.soup.polygons, model.labels);
  return model;
}

} // namespace segment_mesh
