// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_DUMBBELL_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_DUMBBELL_H

#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <vector>

/// The mesh of the examples: two balls and a bar, turned around the x axis in 3,168 triangles. The
/// two rings where the bar meets the balls are concave.
template <typename Mesh, typename Point>
Mesh make_dumbbell()
{
  constexpr int rings = 34, sides = 48;
  const double pi = std::acos(-1.0);
  Mesh mesh;
  const auto add_vertex_at = [&mesh](double x, double y, double z) {
    const auto v = add_vertex(mesh);
    put(CGAL::vertex_point, mesh, v, Point(x, y, z));
    return v;
  };

  // The profile: from pole to pole, a ball of radius 1 around x = -2, a bar of radius 0.3, a ball.
  std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> v;
  const double start = std::asin(0.3); // where the bar leaves the ball
  v.push_back(add_vertex_at(-3, 0, 0));
  for (int i = 1; i < rings; ++i) {
    const int j = i <= rings / 2 ? i : rings - i;
    const double angle = j <= 12 ? j / 12.0 * (pi - start) : pi - start;
    const double on_ball = -2 - std::cos(angle);
    const double x = j <= 12 ? on_ball : on_ball * (17 - j) / 5.0;
    for (int s = 0; s < sides; ++s)
      v.push_back(add_vertex_at(i == j ? x : -x, std::sin(angle) * std::cos(2 * pi * s / sides),
                                std::sin(angle) * std::sin(2 * pi * s / sides)));
  }
  v.push_back(add_vertex_at(3, 0, 0));

  for (int s = 0; s < sides; ++s) {
    const int t = (s + 1) % sides, last = 1 + (rings - 2) * sides;
    CGAL::Euler::add_face(std::vector{v[0], v[1 + t], v[1 + s]}, mesh);
    for (int first = 1; first < last; first += sides) {
      CGAL::Euler::add_face(std::vector{v[first + s], v[first + t], v[first + sides + t]}, mesh);
      CGAL::Euler::add_face(std::vector{v[first + s], v[first + sides + t], v[first + sides + s]},
                            mesh);
    }
    CGAL::Euler::add_face(std::vector{v[last + s], v[last + t], v.back()}, mesh);
  }
  return mesh;
}

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_DUMBBELL_H
