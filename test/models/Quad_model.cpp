// SPDX-License-Identifier: GPL-3.0-or-later

#include "models/Quad_model.h"

#include <random>
#include <utility>

namespace segment_mesh {

namespace {

// The standard fixes the numbers of this engine, but not those of its distributions.
using Engine = std::mt19937;

bool is_by_first_corner(Diagonals diagonals, std::size_t quad, Engine& engine)
{
  if (diagonals == Diagonals::AT_RANDOM)
    return engine() % 2 == 0;
  return diagonals == Diagonals::FIRST || quad % 2 == 0;
}

} // namespace

void split_quads(Labelled_model& model, Diagonals diagonals)
{
  Engine engine;
  Polygons triangles;
  std::vector<std::size_t> labels;
  for (std::size_t f = 0; f < model.soup.polygons.size(); ++f) {
    const Polygon_soup::Polygon& polygon = model.soup.polygons[f];
    if (polygon.size() != 4) {
      triangles.push_back(polygon);
      labels.push_back(model.labels[f]);
      continue;
    }
    const std::size_t i = is_by_first_corner(diagonals, f, engine) ? 0 : 1;
    const std::size_t a = polygon[i], b = polygon[i + 1], c = polygon[i + 2],
                      d = polygon[(i + 3) % 4];
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
    labels.insert(labels.end(), 2, model.labels[f]);
  }
  model.soup.polygons = std::move(triangles);
  model.labels = std::move(labels);
}

void add_noise(Labelled_model& model, double amount)
{
  Engine engine;
  for (Point& p : model.soup.points)
    for (double& coordinate : p)
      coordinate += amount * (2 * (double(engine()) / double(Engine::max())) - 1);
}

} // namespace segment_mesh
