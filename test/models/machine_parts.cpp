// SPDX-License-Identifier: GPL-3.0-or-later

#include "models/machine_parts.h"

#include <cmath>
#include <utility>

namespace segment_mesh {

namespace {

constexpr double pi = 3.141592653589793, quarter = pi / 2;

/// \name Outlines
/// @{
Planar_curve circle(double radius)
{
  return {{radius, -radius, pi}, {-radius, radius, pi}};
}

/// Rounds the corners of a polygon.
Planar_curve rounded(const std::vector<Planar>& corners, double radius)
{
  Planar_curve result;
  const std::size_t size = corners.size();
  std::vector<Planar> begin(size), end(size); // of the arc at each corner
  std::vector<double> turn(size);
  for (std::size_t i = 0; i < size; ++i) {
    const Planar &before = corners[(i + size - 1) % size], &after = corners[(i + 1) % size];
    turn[i] = std::arg((after - corners[i]) / (corners[i] - before));
    const double cut = radius * std::abs(std::tan(turn[i] / 2));
    begin[i] = corners[i] + cut * (before - corners[i]) / std::abs(before - corners[i]);
    end[i] = corners[i] + cut * (after - corners[i]) / std::abs(after - corners[i]);
  }
  for (std::size_t i = 0; i < size; ++i) {
    if (radius > 0)
      result.push_back({begin[i], end[i], turn[i]});
    result.push_back({end[i], begin[(i + 1) % size]});
  }
  return result;
}

std::vector<Planar> rectangle(double length, double width)
{
  return {{length / 2, -width / 2},
          {length / 2, width / 2},
          {-length / 2, width / 2},
          {-length / 2, -width / 2}};
}

std::vector<Planar> star(std::size_t number, double inner, double outer)
{
  std::vector<Planar> result;
  for (std::size_t i = 0; i < number; ++i)
    result.push_back(std::polar(i % 2 == 0 ? outer : inner, 2 * pi * double(i) / double(number)));
  return result;
}

/// Teeth with flanks along rays.
std::vector<Planar> teeth(std::size_t number, double inner, double outer)
{
  std::vector<Planar> result;
  for (std::size_t i = 0; i < 4 * number; ++i)
    result.push_back(std::polar(i % 4 == 0 || i % 4 == 3 ? inner : outer,
                                2 * pi * (double(i) + 0.2) / double(4 * number)));
  return result;
}

Planar_curve stadium(double length, double radius)
{
  const double x = length / 2;
  return {{{-x, -radius}, {x, -radius}},
          {{x, -radius}, {x, radius}, pi},
          {{x, radius}, {-x, radius}},
          {{-x, radius}, {-x, -radius}, pi}};
}
/// @}

/// \name Walls
/// @{

/// A cap, walls through the given points, a cap; and a bore between them.
/// \param turns of each wall, 0 where none is given
std::vector<Wall> walls(const std::vector<Planar>& points, const std::vector<double>& turns = {})
{
  std::vector<Wall> result = {{Wall::CAP}};
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    result.push_back({Wall::OUTER, {points[i], points[i + 1], i < turns.size() ? turns[i] : 0}});
  result.push_back({Wall::CAP});
  const double low = points.front().imag(), high = points.back().imag();
  result.push_back({Wall::BORE, {{0, high}, {0, low}}});
  return result;
}

std::vector<Wall> straight(double height)
{
  return walls({{0, 0}, {0, height}});
}

std::vector<Wall> rounded_above(double height, double radius)
{
  return walls({{0, 0}, {0, height - radius}, {radius, height}}, {0, -quarter});
}

std::vector<Wall> rounded_twice(double height, double radius)
{
  return walls({{radius, 0}, {0, radius}, {0, height - radius}, {radius, height}},
               {-quarter, 0, -quarter});
}
/// @}

struct Shape
{
  std::string name;
  bool has_fillets;
  Loft loft;
};

std::vector<Shape> shapes()
{
  return {
    {"box", false, {rounded(rectangle(3, 2), 0), 0, straight(1)}},
    {"nut",
     false,
     {rounded(star(6, 1, 1), 0), 0.5, walls({{0.1, 0}, {0, 0.15}, {0, 0.7}, {0.1, 0.85}})}},
    {"cylinder", false, {circle(0.6), 0, straight(1.5)}},
    {"frustum", false, {circle(1), 0, walls({{0, 0}, {0.6, 1.5}})}},
    {"stepped_shaft",
     false,
     {circle(1), 0,
      walls({{0.5, 0}, {0.5, 1.5}, {0, 1.5}, {0, 2}, {0.4, 2}, {0.4, 3.5}, {0.5, 3.6}})}},
    {"flange", false, {circle(2), 0.6, walls({{0, 0}, {0, 0.4}, {1, 0.4}, {1, 1.5}, {1.1, 1.6}})}},
    {"gear", false, {rounded(teeth(10, 1.5, 1.9), 0), 0.5, straight(0.6)}},
    {"bored_plate", false, {rounded(rectangle(4, 3), 0), 0.8, straight(0.5)}},
    {"pulley", false, {circle(1.5), 0.4, walls({{0, 0}, {0, 0.2}, {0.5, 0.5}, {0, 0.8}, {0, 1}})}},
    {"lens_mount",
     false,
     {circle(1), 0, walls({{0.3, 0}, {0, 0.6}, {0.2, 0.6}, {0.5, 1.1}}, {-0.6, 0, -0.6})}},

    {"rounded_plate", true, {rounded(rectangle(4, 3), 0.6), 0, straight(0.5)}},
    {"pillow", true, {rounded(rectangle(3, 2), 0.25), 0, rounded_twice(1, 0.25)}},
    {"button", true, {circle(1), 0, rounded_above(0.8, 0.25)}},
    {"filleted_shaft",
     true,
     {circle(1), 0,
      walls({{0.5, 0}, {0.5, 1.3}, {0.3, 1.5}, {0.1, 1.5}, {0, 1.6}, {0, 2.2}, {0.5, 2.2}},
            {0, quarter, 0, -quarter})}},
    {"filleted_flange",
     true,
     {circle(2), 0.5,
      walls({{0, 0}, {0, 0.3}, {0.1, 0.4}, {0.8, 0.4}, {1, 0.6}, {1, 1.5}},
            {0, -quarter, 0, quarter})}},
    {"link", true, {stadium(3, 0.8), 0.4, straight(0.5)}},
    {"capsule", true, {circle(0.5), 0, walls({{0, 0}, {0, 1.2}, {0.5, 1.7}}, {0, -quarter})}},
    {"rounded_gear", true, {rounded(teeth(8, 1.4, 1.9), 0.08), 0, straight(0.6)}},
    {"tray", true, {rounded(rectangle(4, 3), 0.7), 0, rounded_above(0.6, 0.35)}},
    {"rope_pulley",
     true,
     {circle(1.5), 0.4,
      walls({{0.1, 0}, {0, 0.1}, {0, 0.25}, {0, 0.75}, {0, 0.9}, {0.1, 1}},
            {-quarter, 0, pi * 0.9, 0, -quarter})}}};
}

} // namespace

Labelled_model Machine_part::make() const
{
  Labelled_model model = tessellate(loft, tessellation);
  model.name = name;
  return model;
}

const std::vector<Machine_part>& machine_parts()
{
  static const std::vector<Machine_part> parts = [] {
    const double angles[] = {5, 30, 11.25, 22.5, 7.5}, edge_lengths[] = {0.1, 0.2, 0.14};
    const double unbounded = 1e9, jitter = 0.2;
    std::vector<Machine_part> result;
    std::size_t i = 0;
    for (const Shape& shape : shapes()) {
      result.push_back(
        {shape.name + "_long", shape.has_fillets, shape.loft, {angles[i % 5], unbounded, 0}});
      result.push_back(
        {shape.name + "_even", shape.has_fillets, shape.loft, {15, edge_lengths[i % 3], jitter}});
      ++i;
    }
    return result;
  }();
  return parts;
}

} // namespace segment_mesh
