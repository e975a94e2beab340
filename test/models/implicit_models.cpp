// SPDX-License-Identifier: GPL-3.0-or-later

#include "models/implicit_models.h"

#include "models/Implicit_shape.h"
#include "models/Quad_model.h"
#include "soup/vector_algebra.h"

#include <algorithm>
#include <cmath>

namespace segment_mesh {

namespace {

/// A cylinder from `a` to `b` with hemispheres at its ends.
Distance capsule(const Point& a, const Point& b, double radius)
{
  const Point axis = minus(b, a);
  return [=](const Point& p) {
    const double t = inner_product(minus(p, a), axis) / inner_product(axis, axis);
    const Point nearest = plus(a, times((std::min)(1.0, (std::max)(0.0, t)), axis));
    const Point v = minus(p, nearest);
    return std::sqrt(inner_product(v, v)) - radius;
  };
}

/// A box with rounded edges: all that is at most `radius` from the box of the given half sides.
Distance rounded_box(const Point& center, const Point& half_sides, double radius)
{
  return [=](const Point& p) {
    Point outside;
    double most = -1e9;
    for (std::size_t i = 0; i < 3; ++i) {
      const double d = std::abs(p[i] - center[i]) - half_sides[i];
      outside[i] = (std::max)(d, 0.0);
      most = (std::max)(most, d);
    }
    return std::sqrt(inner_product(outside, outside)) + (std::min)(most, 0.0) - radius;
  };
}

/// \param edge_length the usual one; a much coarser grid would miss the limbs
Labelled_model mesh(const char* name, const Implicit_shape& shape, const Point& inside,
                    double edge_length, const Making& making)
{
  const double least_fineness = 0.8;
  Labelled_model model = make_labelled_model(
    shape, inside, edge_length / (std::max)(least_fineness, making.fineness));
  model.name = name;
  return model;
}

} // namespace

Labelled_model make_mug(const Making& making)
{
  // The wall in a half plane through the axis: a line to the corner, and up; with a thickness.
  const double radius = 0.6, height = 1.2, half_thickness = 0.1;
  const Distance cup = [=](const Point& p) {
    const double across = std::hypot(p[0], p[1]);
    const double to_floor = std::hypot(across - (std::min)(across, radius), p[2]);
    const double to_wall = std::hypot(across - radius,
                                      p[2] - (std::min)(height, (std::max)(0.0, p[2])));
    return (std::min)(to_floor, to_wall) - half_thickness;
  };
  // A ring around the y axis, without what would be inside of the cup.
  const Distance handle = [=](const Point& p) {
    const double from_circle = std::hypot(p[0] - radius, p[2] - height / 2) - 0.4;
    const double inside = radius - std::hypot(p[0], p[1]);
    return (std::max)(std::hypot(from_circle, p[1]) - 0.1, inside);
  };
  Implicit_shape shape(0.04);
  shape.add(cup, 0);
  shape.add(handle, 1);
  return mesh("mug", shape, {0, 0, 0}, 0.065, making);
}

Labelled_model make_hammer(const Making& making)
{
  Implicit_shape shape(0.03);
  shape.add(rounded_box({0, 0, 2}, {0.55, 0.16, 0.16}, 0.06), 0);
  shape.add(capsule({0, 0, 0}, {0, 0, 2}, 0.14), 1);
  return mesh("hammer", shape, {0, 0, 2}, 0.055, making);
}

Labelled_model make_octopus(const Making& making)
{
  Implicit_shape shape(0.06);
  shape.add(ellipsoid({0, 0, -0.25}, {0, 0, 1.2}, 0.55), 0);
  for (std::size_t i = 0; i < 8; ++i) {
    const double angle = 6.283185307179586 * double(i) / 8, c = std::cos(angle),
                 s = std::sin(angle);
    const Point shoulder = {0.35 * c, 0.35 * s, 0}, elbow = {1.05 * c, 1.05 * s, -0.3},
                end = {1.7 * c, 1.7 * s, -0.1};
    shape.add(capsule(shoulder, elbow, 0.11), i + 1);
    shape.add(capsule(elbow, end, 0.1), i + 1);
  }
  return mesh("octopus", shape, {0, 0, 0.3}, 0.06, making);
}

Labelled_model make_hand(const Making& making)
{
  Implicit_shape shape(0.05);
  shape.add(rounded_box({0, 0, 0}, {0.38, 0.06, 0.4}, 0.1), 0);
  const double lengths[] = {0.6, 0.75, 0.7, 0.5};
  for (std::size_t i = 0; i < 4; ++i) {
    const double x = -0.39 + 0.26 * double(i), spread = 0.3 * x;
    shape.add(capsule({x, 0, 0.4}, {x + spread, 0, 0.55 + lengths[i]}, 0.105), i + 1);
  }
  shape.add(capsule({-0.35, 0, -0.2}, {-0.95, 0.1, 0.25}, 0.12), 5);
  Labelled_model model = mesh("hand", shape, {0, 0, 0}, 0.055, making);
  add_noise(model, making.noise * 0.004 / making.fineness);
  return model;
}

Labelled_model make_quadruped(const Making& making)
{
  Implicit_shape shape(0.05);
  shape.add(ellipsoid({-0.85, 0, 0}, {0.85, 0, 0}, 0.4), 0);
  shape.add(ellipsoid({0.6, 0, 0.15}, {1.35, 0, 0.65}, 0.24), 1);
  shape.add(capsule({-0.75, 0, 0.1}, {-1.35, 0, 0.45}, 0.08), 2);
  std::size_t part = 3;
  for (const double x : {-0.45, 0.45})
    for (const double y : {-0.17, 0.17})
      shape.add(capsule({x, y, -0.2}, {1.1 * x, 1.3 * y, -0.95}, 0.11), part++);
  return mesh("quadruped", shape, {0, 0, 0}, 0.06, making);
}

} // namespace segment_mesh
