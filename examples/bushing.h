// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_BUSHING_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_BUSHING_H

#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <vector>

/// The machine part of the examples: a ring around the z axis with a hole of radius 1, 3 high, its
/// outer edges of radius 4 rounded by fillets of radii 0.5 (below) and 0.2, in 1,536 triangles.
template <typename Mesh, typename Point>
Mesh make_bushing()
{
  constexpr int sides = 48, facets = 6;
  const double pi = std::acos(-1.0);
  std::vector<std::array<double, 2>> profile = {{1, 3}, {1, 0}}; // r, z; outside to the right
  const auto add_fillet = [&](double radius, double z, double start) {
    for (int i = 0; i <= facets; ++i) {
      const double angle = (start + double(i) / facets) * pi / 2;
      profile.push_back({4 - radius + radius * std::cos(angle), z + radius * std::sin(angle)});
    }
  };
  add_fillet(0.5, 0.5, -1);
  add_fillet(0.2, 2.8, 0);

  Mesh mesh;
  std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> v;
  for (const auto& [r, z] : profile)
    for (int s = 0; s < sides; ++s) {
      v.push_back(add_vertex(mesh));
      put(CGAL::vertex_point, mesh, v.back(),
          Point(r * std::cos(2 * pi * s / sides), r * std::sin(2 * pi * s / sides), z));
    }
  for (std::size_t i = 0; i < profile.size(); ++i)
    for (int s = 0; s < sides; ++s) {
      const auto at = [&](std::size_t ring, int side) {
        return v[ring % profile.size() * sides + std::size_t(side % sides)];
      };
      CGAL::Euler::add_face(std::vector{at(i, s), at(i, s + 1), at(i + 1, s + 1)}, mesh);
      CGAL::Euler::add_face(std::vector{at(i, s), at(i + 1, s + 1), at(i + 1, s)}, mesh);
    }
  return mesh;
}

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_BUSHING_H
