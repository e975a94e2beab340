// SPDX-License-Identifier: GPL-3.0-or-later

#include "make_triangles.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <random>
#include <stdexcept>
#include <unordered_map>

namespace speed_benchmark {

namespace {

using Point = Triangles::Point;
using Index = std::uint32_t;

double mean_edge_length(const Triangles& triangles)
{
  double sum = 0;
  for (const auto& t : triangles.corners)
    for (std::size_t i = 0; i < 3; ++i) {
      const Point &a = triangles.points[t[i]], &b = triangles.points[t[(i + 1) % 3]];
      sum += std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                       (a[2] - b[2]) * (a[2] - b[2]));
    }
  return sum / double(3 * triangles.corners.size());
}

/// In [-1, 1), from a number: splitmix64 (Steele, Lea, Flood 2014), so no generator has a state.
double noise(std::uint64_t number)
{
  std::uint64_t z = (number + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return double((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;
}

} // namespace

Triangles read_triangles(const std::string& file)
{
  std::ifstream in(file);
  std::string magic;
  std::size_t points = 0, faces = 0, edges = 0;
  if (!(in >> magic >> points >> faces >> edges) || magic != "OFF")
    throw std::runtime_error(file + ": not found, or no OFF file");
  Triangles result;
  result.points.resize(points);
  result.corners.resize(faces);
  for (Point& p : result.points)
    in >> p[0] >> p[1] >> p[2];
  for (auto& t : result.corners) {
    std::size_t size = 0;
    in >> size >> t[0] >> t[1] >> t[2];
    if (size != 3 || *std::max_element(t.begin(), t.end()) >= points)
      in.setstate(std::ios::failbit);
  }
  if (!in)
    throw std::runtime_error(file + ": not what its head says, or not triangles alone");
  return result;
}

Triangles subdivided(const Triangles& coarse)
{
  Triangles fine;
  fine.points = coarse.points;
  fine.corners.reserve(4 * coarse.corners.size());
  std::unordered_map<std::uint64_t, Index> middle_of; // by the ends of an edge
  middle_of.reserve(coarse.corners.size() * 3 / 2);
  const auto middle = [&](Index u, Index v) {
    const auto [low, high] = std::minmax(u, v);
    const auto [place, is_new] = middle_of.emplace(std::uint64_t(low) << 32 | high,
                                                   Index(fine.points.size()));
    if (is_new) {
      const Point a = coarse.points[low], b = coarse.points[high];
      fine.points.push_back({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2});
    }
    return place->second;
  };
  for (const auto& t : coarse.corners) {
    const Index a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
    for (const Triangles::Corners& s :
         {Triangles::Corners{t[0], a, c}, {a, t[1], b}, {c, b, t[2]}, {a, b, c}})
      fine.corners.push_back(s);
  }
  fine.points.shrink_to_fit();
  return fine;
}

Triangles roughened(Triangles triangles, double amplitude)
{
  const double most = amplitude * mean_edge_length(triangles);
  std::uint64_t number = 0;
  for (Point& p : triangles.points)
    for (double& x : p)
      x += most * noise(number++);
  return triangles;
}

Triangles shuffled(const Triangles& triangles)
{
  std::mt19937_64 random(1);
  std::vector<Index> new_place(triangles.points.size());
  std::iota(new_place.begin(), new_place.end(), Index(0));
  std::shuffle(new_place.begin(), new_place.end(), random);
  Triangles result = triangles;
  for (std::size_t v = 0; v < new_place.size(); ++v)
    result.points[new_place[v]] = triangles.points[v];
  for (Triangles::Corners& corners : result.corners)
    for (Index& v : corners)
      v = new_place[v];
  std::shuffle(result.corners.begin(), result.corners.end(), random);
  return result;
}

Triangles wavy_torus(std::size_t number_of_faces)
{
  const auto n = Index(std::llround(std::sqrt(double(number_of_faces) / 2)));
  const double step = 2 * std::acos(-1.0) / double(n);
  Triangles torus;
  torus.points.reserve(std::size_t(n) * n);
  torus.corners.reserve(2 * std::size_t(n) * n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      const double a = step * i, b = step * j;
      const double r = 1 + 0.2 * std::sin(7 * a) * std::sin(5 * b);
      torus.points.push_back({(3 + r * std::cos(b)) * std::cos(a),
                              (3 + r * std::cos(b)) * std::sin(a), r * std::sin(b)});
      const Index i1 = (i + 1) % n, j1 = (j + 1) % n;
      torus.corners.push_back({i * n + j, i1 * n + j, i1 * n + j1});
      torus.corners.push_back({i * n + j, i1 * n + j1, i * n + j1});
    }
  return torus;
}

} // namespace speed_benchmark
