// SPDX-License-Identifier: GPL-3.0-or-later

#include "view/choose_viewpoint.h"

#include "soup/vector_algebra.h"
#include "view/Sample_buffer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

namespace segment_mesh {

namespace {

constexpr double pi = 3.14159265358979323846;

/// See `choose_viewpoint()`.
double worth(const Scene& scene, const Viewpoint& viewpoint)
{
  constexpr std::size_t size = 64;
  Sample_buffer buffer(size, size);
  draw_faces(
    scene, Projection(viewpoint, size, size, size / 2.0),
    [](std::size_t, std::size_t) { return 1; }, buffer);
  std::map<std::size_t, std::size_t> samples_of_label;
  for (std::size_t row = 0; row < size; ++row)
    for (std::size_t column = 0; column < size; ++column)
      if (const auto face = buffer.at(column, row).face; face != Sample_buffer::no_face)
        ++samples_of_label[scene.labels[face]];
  double sum = 0;
  for (const auto& [label, samples] : samples_of_label)
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

} // namespace segment_mesh
