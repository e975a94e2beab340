// SPDX-License-Identifier: GPL-3.0-or-later

#include "view/choose_viewpoint.h"

#include "soup/vector_algebra.h"
#include "view/Sample_buffer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>

namespace segment_mesh {

namespace {

constexpr double pi = 3.14159265358979323846;

/// See `choose_viewpoint()`. The roots are added in the order in which the segments appear in a
/// small picture, not by a hash.
double worth(const Scene& scene, const Viewpoint& viewpoint)
{
  constexpr std::size_t size = 64;
  Sample_buffer buffer(size, size);
  draw_faces(
    scene, Projection(viewpoint, size, size, size / 2.0), [](Scene::Index) { return 1.0; }, buffer);
  std::unordered_map<std::size_t, std::size_t> position_of_label;
  std::vector<std::size_t> visible;
  for (std::size_t i = 0; i < size * size; ++i) {
    if (buffer.face(i) == Sample_buffer::no_face)
      continue;
    const auto [entry, is_new] = position_of_label.emplace(scene.labels[buffer.face(i)],
                                                           visible.size());
    if (is_new)
      visible.push_back(0);
    ++visible[entry->second];
  }
  double sum = 0;
  for (std::size_t samples : visible)
    sum += std::sqrt(double(samples));
  return sum;
}

} // namespace

Viewpoint viewpoint_from(double azimuth, double elevation, const Up_direction& up)
{
  constexpr double radian = pi / 180;
  const double a = azimuth * radian, e = elevation * radian;
  // The axis that is up, and the two that follow it; to turn it down also turns the last one.
  const auto vector = [&](double upward, double forward, double sideward) {
    Point v = {up.sign * upward, forward, up.sign * sideward};
    // emscripten 3.1.6 loses elements that are set by computed indices.
    std::rotate(v.begin(), v.end() - std::ptrdiff_t(up.axis), v.end());
    return v;
  };
  Viewpoint v;
  v.toward_viewer = vector(std::sin(e), std::cos(e) * std::cos(a), std::cos(e) * std::sin(a));
  v.right = vector(0, -std::sin(a), std::cos(a));
  v.up = cross_product(v.toward_viewer, v.right);
  return v;
}

std::vector<Viewpoint> candidate_viewpoints(const Up_direction& up)
{
  constexpr std::size_t number_of_azimuths = 12;
  std::vector<Viewpoint> result;
  for (double elevation : {15.0, 40.0})
    for (std::size_t i = 0; i < number_of_azimuths; ++i)
      result.push_back(viewpoint_from(360.0 * double(i) / number_of_azimuths, elevation, up));
  return result;
}

Viewpoint choose_viewpoint(const Scene& scene, const Up_direction& up)
{
  const std::vector<Viewpoint> candidates = candidate_viewpoints(up);
  std::vector<double> worths;
  for (const Viewpoint& candidate : candidates)
    worths.push_back(worth(scene, candidate));
  return candidates[std::size_t(std::max_element(worths.begin(), worths.end()) - worths.begin())];
}

Viewpoint choose_viewpoint(const Polygon_soup& soup, const std::vector<std::size_t>& labels,
                           const Up_direction& up)
{
  return choose_viewpoint(make_scene(soup, labels), up);
}

} // namespace segment_mesh
