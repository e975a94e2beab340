// SPDX-License-Identifier: GPL-3.0-or-later

#include "sheets.h"

#include "random_numbers.h"

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <utility>

namespace princeton_benchmark {

namespace {

using Random = std::mt19937;

/// From the unit square to a surface.
using Map = std::function<Point(double u, double v)>;

/// Squares, each of two triangles, of a grid of points.
std::vector<std::vector<std::size_t>> triangles_of_grid(std::size_t columns, std::size_t rows)
{
  std::vector<std::vector<std::size_t>> triangles;
  for (std::size_t r = 0; r + 1 < rows; ++r)
    for (std::size_t c = 0; c + 1 < columns; ++c) {
      const std::size_t i = r * columns + c;
      triangles.push_back({i, i + 1, i + columns + 1});
      triangles.push_back({i, i + columns + 1, i + columns});
    }
  return triangles;
}

/// A grid on a surface, whose inner points are moved at random, seen from a random side.
Soup surface(const Map& map, Random& random)
{
  const std::size_t columns = 20 + random() % 50, rows = 20 + random() % 50;
  Soup soup{{}, triangles_of_grid(columns, rows)};
  const double most = uniform(random, 0, 0.3); // of the width of a square
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c) {
      const auto place = [&](std::size_t i, std::size_t size) {
        const bool is_inner = i > 0 && i + 1 < size;
        return (double(i) + (is_inner ? uniform(random, -most, most) : 0)) / double(size - 1);
      };
      const double u = place(c, columns), v = place(r, rows);
      soup.points.push_back(map(u, v));
    }
  if (random() % 2 == 0)
    for (auto& triangle : soup.triangles)
      std::swap(triangle[1], triangle[2]);
  return soup;
}

Map plane(Random& random)
{
  const double width = uniform(random, 0.3, 1), wave = uniform(random, 0, 0.4),
               waves = uniform(random, 2, 12), hole = uniform(random, 0.2, 0.6),
               turn = uniform(random, 2, 6.2);
  if (random() % 2 == 0) // a figure with a wavy outline
    return [=](double u, double v) {
      return Point(width * (u - 0.5) * (1 + wave * std::sin(waves * v)), v, 0);
    };
  return [=](double u, double v) { // a ring that is not closed
    const double radius = hole + (1 - hole) * v;
    return Point(radius * std::cos(turn * u), radius * std::sin(turn * u), 0);
  };
}

Map hill(Random& random)
{
  const double x = uniform(random), y = uniform(random), width = uniform(random, 0.2, 0.6),
               slope = uniform(random, 0.1, 0.8), length = uniform(random, 0.5, 1);
  return [=](double u, double v) {
    const double a = (u - x) / width, b = length * (v - y) / width;
    return Point(u, length * v, slope * width * std::exp(-a * a - b * b));
  };
}

Map tube(Random& random)
{
  const double turn = uniform(random, 1, 6.2), length = uniform(random, 0.5, 6),
               end = uniform(random, 0.4, 1);
  return [=](double u, double v) {
    const double radius = 1 + (end - 1) * v;
    return Point(radius * std::cos(turn * u), radius * std::sin(turn * u), length * v);
  };
}

Map terrain(Random& random)
{
  struct Wave
  {
    double x, y, phase, height;
  };
  std::vector<Wave> waves;
  const double slope = uniform(random, 0.03, 0.2);
  for (int i = 0; i < 10; ++i) {
    const double frequency = uniform(random, 3, 20), angle = uniform(random, 0, 2 * CGAL_PI);
    waves.push_back({frequency * std::cos(angle), frequency * std::sin(angle),
                     uniform(random, 0, 2 * CGAL_PI), slope / frequency});
  }
  return [=](double u, double v) {
    double z = 0;
    for (const Wave& wave : waves)
      z += wave.height * std::sin(wave.x * u + wave.y * v + wave.phase);
    return Point(u, v, z);
  };
}

} // namespace

std::vector<Sheet> make_sheets(unsigned seed)
{
  constexpr std::size_t sheets_of_kind = 5;
  Random random(seed);
  std::vector<Sheet> sheets;
  const std::vector<std::pair<const char*, Map (*)(Random&)>> kinds = {
    {"Plane", plane}, {"Hill", hill}, {"Tube", tube}, {"Terrain", terrain}};
  for (const auto& [kind, make] : kinds)
    for (std::size_t i = 0; i < sheets_of_kind; ++i) {
      Soup soup = surface(make(random), random);
      std::vector<int> labels(soup.triangles.size(), 0);
      sheets.push_back({kind, {std::move(soup), 1, {{std::move(labels), 1}}}});
    }
  return sheets;
}

} // namespace princeton_benchmark
