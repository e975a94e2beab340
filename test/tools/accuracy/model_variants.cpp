// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_variants.h"

#include "models/Quad_model.h"
#include "soup/vector_algebra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace princeton_benchmark {

using segment_mesh::cross_product;
using segment_mesh::inner_product;
using segment_mesh::Labelled_model;
using segment_mesh::Making;
using segment_mesh::minus;
using segment_mesh::Model_recipe;
using segment_mesh::plus;
using segment_mesh::Point;
using segment_mesh::Polygon_soup;
using segment_mesh::times;

namespace {

// The standard fixes the numbers of this engine, but not those of its distributions.
using Engine = std::mt19937;
using Edge = std::array<std::size_t, 2>; // from a point to a point

double norm(const Point& v)
{
  return std::sqrt(inner_product(v, v));
}

double mean_edge_length(const Polygon_soup& soup)
{
  double sum = 0, number = 0;
  for (const Polygon_soup::Polygon& polygon : soup.polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::size_t j = (i + 1) % polygon.size();
      sum += norm(minus(soup.points[polygon[i]], soup.points[polygon[j]]));
      ++number;
    }
  return sum / number;
}

/// Exchanges the diagonals of pairs of triangles, each triangle once at most.
class Flipping
{
public:
  Flipping(Labelled_model& model, std::uint32_t seed)
    : m_model(model)
    , m_polygons(model.soup.polygons)
    , m_engine(seed)
    , m_is_new(m_polygons.size(), false)
  {
    for (std::size_t f = 0; f < m_polygons.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i)
        m_face_of[{m_polygons[f][i], m_polygons[f][(i + 1) % 3]}] = f;
  }

  void run()
  {
    std::vector<Edge> edges;
    for (const auto& [edge, face] : m_face_of)
      if (edge[0] < edge[1] && m_face_of.count({edge[1], edge[0]}) > 0)
        edges.push_back(edge);
    for (std::size_t i = edges.size(); i > 1; --i)
      std::swap(edges[i - 1], edges[m_engine() % i]);
    for (const Edge& edge : edges)
      if (m_engine() % 2 == 0)
        flip(edge);
  }

private:
  void flip(const Edge& edge)
  {
    const std::size_t f = m_face_of.at(edge), g = m_face_of.at({edge[1], edge[0]});
    if (m_is_new[f] || m_is_new[g] || m_model.labels[f] != m_model.labels[g])
      return;
    const std::size_t a = edge[0], b = edge[1], c = third(f, edge), d = third(g, edge);
    if (m_face_of.count({c, d}) > 0 || m_face_of.count({d, c}) > 0 || !keeps_surface(a, b, c, d))
      return;
    m_polygons.replace(f, {a, d, c});
    m_polygons.replace(g, {d, b, c});
    m_is_new[f] = m_is_new[g] = true;
    // Only these are looked up again: the other edges of new faces are of no use.
    m_face_of[{c, d}] = g;
    m_face_of[{d, c}] = f;
  }

  std::size_t third(std::size_t face, const Edge& edge) const
  {
    for (std::size_t corner : m_polygons[face])
      if (corner != edge[0] && corner != edge[1])
        return corner;
    return edge[0];
  }

  Point normal(std::size_t a, std::size_t b, std::size_t c) const
  {
    const auto& p = m_model.soup.points;
    const Point n = cross_product(minus(p[b], p[a]), minus(p[c], p[a]));
    return times(1 / norm(n), n);
  }

  /// Of the triangles a b c and b a d.
  bool keeps_surface(std::size_t a, std::size_t b, std::size_t c, std::size_t d) const
  {
    const auto& p = m_model.soup.points;
    if (norm(minus(p[c], p[d])) > 2 * norm(minus(p[a], p[b])))
      return false;
    const double least_cosine = std::cos(30 * 3.14159265358979 / 180);
    for (const Point& before : {normal(a, b, c), normal(b, a, d)})
      for (const Point& after : {normal(a, d, c), normal(d, b, c)})
        if (!(inner_product(before, after) >= least_cosine))
          return false;
    return true;
  }

  Labelled_model& m_model;
  segment_mesh::Polygons& m_polygons;
  Engine m_engine;
  std::vector<char> m_is_new;
  std::map<Edge, std::size_t> m_face_of;
};

} // namespace

Labelled_model with_noise(Labelled_model model, double share, std::uint32_t seed)
{
  Engine engine(seed);
  const double amount = share * mean_edge_length(model.soup) * std::sqrt(3.0);
  for (Point& p : model.soup.points)
    for (double& coordinate : p)
      coordinate += amount * (2 * (double(engine()) / double(Engine::max())) - 1);
  return model;
}

Labelled_model split_into_four(const Labelled_model& model)
{
  Labelled_model result = model;
  result.soup.polygons = {};
  result.labels.clear();
  std::vector<Point>& points = result.soup.points;
  std::map<Edge, std::size_t> middles;
  const auto middle = [&](std::size_t a, std::size_t b) {
    const auto entry = middles.emplace(Edge{(std::min)(a, b), (std::max)(a, b)}, points.size());
    if (entry.second)
      points.push_back(times(0.5, plus(points[a], points[b])));
    return entry.first->second;
  };
  for (std::size_t f = 0; f < model.soup.polygons.size(); ++f) {
    const Polygon_soup::Polygon& corners = model.soup.polygons[f];
    const std::size_t n = corners.size();
    std::vector<std::size_t> inner;
    for (std::size_t i = 0; i < n; ++i)
      inner.push_back(middle(corners[i], corners[(i + 1) % n]));
    if (n > 3) {
      const std::size_t center = points.size();
      points.push_back(centroid(model.soup, corners));
      for (std::size_t i = 0; i < n; ++i)
        result.soup.polygons.push_back({corners[i], inner[i], center, inner[(i + n - 1) % n]});
    } else {
      for (std::size_t i = 0; i < n; ++i)
        result.soup.polygons.push_back({corners[i], inner[i], inner[(i + n - 1) % n]});
      result.soup.polygons.push_back(inner);
    }
    result.labels.resize(result.soup.polygons.size(), model.labels[f]);
  }
  return result;
}

Labelled_model with_flipped_edges(Labelled_model model, std::uint32_t seed)
{
  split_quads(model, segment_mesh::Diagonals::AT_RANDOM);
  Flipping(model, seed).run();
  return model;
}

Labelled_model with_holes(const Labelled_model& model, double share, std::uint32_t seed)
{
  constexpr std::size_t faces_per_hole = 10;
  const Polygon_soup& soup = model.soup;
  const std::size_t size = soup.polygons.size();
  std::vector<std::vector<std::size_t>> faces_at(soup.points.size());
  for (std::size_t f = 0; f < size; ++f)
    for (const std::size_t corner : soup.polygons[f])
      faces_at[corner].push_back(f);
  Engine engine(seed);
  std::vector<bool> is_missing(size, false);
  for (std::size_t missing = 0; double(missing) < share * double(size);) {
    std::vector<std::size_t> hole = {engine() % size};
    for (std::size_t i = 0; i < hole.size() && hole.size() < faces_per_hole; ++i)
      for (const std::size_t corner : soup.polygons[hole[i]])
        for (const std::size_t f : faces_at[corner])
          if (hole.size() < faces_per_hole && std::find(hole.begin(), hole.end(), f) == hole.end())
            hole.push_back(f);
    for (const std::size_t f : hole) {
      missing += !is_missing[f];
      is_missing[f] = true;
    }
  }
  Labelled_model result = model;
  result.soup.polygons = {};
  result.labels.clear();
  for (std::size_t f = 0; f < size; ++f)
    if (!is_missing[f]) {
      const Polygon_soup::Polygon& corners = soup.polygons[f];
      result.soup.polygons.push_back(std::vector<std::size_t>(corners.begin(), corners.end()));
      result.labels.push_back(model.labels[f]);
    }
  return result;
}

std::vector<Variant> model_variants(std::uint32_t seed)
{
  const auto as = [](double fineness, double noise) {
    return [=](const Model_recipe& recipe) { return recipe.make({fineness, noise}); };
  };
  std::vector<Variant> variants = {
    {"as it is", as(1, 1)},
    {"clean", as(1, 0)},
    {"finer", as(2, 1)},
    {"coarser", as(0.5, 1)},
    {"in four", [](const Model_recipe& recipe) { return split_into_four(recipe.make()); }}};
  for (std::uint32_t s = seed; s < seed + 3; ++s)
    variants.push_back({"noise " + std::to_string(s), [s](const Model_recipe& recipe) {
                          return with_noise(recipe.make(), 0.005, s);
                        }});
  for (std::uint32_t s = seed; s < seed + 2; ++s)
    variants.push_back({"flips " + std::to_string(s), [s](const Model_recipe& recipe) {
                          return with_flipped_edges(recipe.make(), s);
                        }});
  return variants;
}

} // namespace princeton_benchmark
