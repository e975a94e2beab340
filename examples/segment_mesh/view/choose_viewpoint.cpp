// SPDX-License-Identifier: GPL-3.0-or-later

#include "view/choose_viewpoint.h"

#include "soup/vector_algebra.h"
#include "view/Projection.h"
#include "view/Sample_buffer.h"
#include "view/draw_faces.h"

#include <cmath>
#include <unordered_map>

namespace segment_mesh {

namespace {

constexpr double pi = 3.14159265358979323846;

/// A small picture of which face is seen where.
Sample_buffer draw_thumbnail(const Scene& scene, const Viewpoint& viewpoint)
{
  constexpr std::size_t size = 64;
  Sample_buffer buffer(size, size);
  const Projection projection(viewpoint, size, size, size / 2.0);
  draw_faces(
    scene, projection, [](Scene::Index) { return 1.0; }, buffer);
  return buffer;
}

/// The roots are added in the order in which the segments appear in the picture, not by a hash.
double worth(const Scene& scene, const Viewpoint& viewpoint)
{
  const Sample_buffer buffer = draw_thumbnail(scene, viewpoint);
  std::unordered_map<std::size_t, std::size_t> position_of_label;
  std::vector<std::size_t> visible;
  for (std::size_t i = 0; i < buffer.width() * buffer.height(); ++i) {
    if (buffer.face(i) == Sample_buffer::no_face)
      continue;
    const std::size_t label = scene.labels[buffer.face(i)];
    const auto entry = position_of_label.emplace(label, visible.size());
    if (entry.second)
      visible.push_back(0);
    ++visible[entry.first->second];
  }
  double sum = 0;
  for (std::size_t samples : visible)
    sum += std::sqrt(double(samples));
  return sum;
}

} // namespace

Viewpoint viewpoint_from(double azimuth, double elevation)
{
  constexpr double radian = pi / 180;
  const double a = azimuth * radian, e = elevation * radian;
  Viewpoint v;
  v.toward_viewer = {std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
  v.right = {std::cos(a), 0, -std::sin(a)};
  v.up = cross_product(v.toward_viewer, v.right);
  return v;
}

std::vector<Viewpoint> candidate_viewpoints()
{
  constexpr std::size_t number_of_azimuths = 12;
  std::vector<Viewpoint> result;
  for (double elevation : {15.0, 40.0})
    for (std::size_t i = 0; i < number_of_azimuths; ++i)
      result.push_back(viewpoint_from(360.0 * double(i) / number_of_azimuths, elevation));
  return result;
}

Viewpoint choose_viewpoint(const Scene& scene)
{
  const std::vector<Viewpoint> candidates = candidate_viewpoints();
  std::size_t best = 0;
  double best_worth = -1;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (const double w = worth(scene, candidates[i]); w > best_worth) {
      best = i;
      best_worth = w;
    }
  return candidates[best];
}

Viewpoint choose_viewpoint(const Polygon_soup& soup, const std::vector<std::size_t>& labels)
{
  return choose_viewpoint(make_scene(soup, labels));
}

} // namespace segment_mesh
