// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_DRAW_FACES_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_DRAW_FACES_H

#include "view/Projection.h"
#include "view/Sample_buffer.h"
#include "view/Scene.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace segment_mesh {

/// The faces, nearest first, by their nearest corners.
inline std::vector<Sample_buffer::Index>
faces_nearest_first(const Scene& scene, const std::vector<Screen_point>& screen)
{
  std::vector<double> depths(scene.number_of_faces(), std::numeric_limits<double>::infinity());
  for (std::size_t f = 0; f < depths.size(); ++f)
    for (Scene::Index c = scene.first_corners[f]; c < scene.first_corners[f + 1]; ++c)
      depths[f] = (std::min)(depths[f], screen[scene.corners[c]].depth);
  std::vector<Sample_buffer::Index> order(depths.size());
  std::iota(order.begin(), order.end(), Sample_buffer::Index(0));
  std::sort(order.begin(), order.end(),
            [&](Sample_buffer::Index f, Sample_buffer::Index g) { return depths[f] < depths[g]; });
  return order;
}

/// Draws all faces of a scene; `light(c)` is the light at the corner c of `Scene::corners`.
template <typename Light>
void draw_faces(const Scene& scene, const Projection& projection, const Light& light,
                Sample_buffer& buffer)
{
  constexpr double area_worth_sorting = 100; // some 16 layers of faces
  std::vector<Screen_point> screen;
  screen.reserve(scene.points.size());
  for (const Point& p : scene.points)
    screen.push_back(projection(p));
  std::vector<Sample_buffer::Corner> corners;
  const auto draw = [&](Sample_buffer::Index f) {
    corners.clear();
    for (Scene::Index c = scene.first_corners[f]; c < scene.first_corners[f + 1]; ++c) {
      const Screen_point& s = screen[scene.corners[c]];
      corners.push_back({s.x, s.y, s.depth, light(c)});
    }
    buffer.draw_polygon(corners, f);
  };
  if (scene.area > area_worth_sorting)
    for (const Sample_buffer::Index f : faces_nearest_first(scene, screen))
      draw(f);
  else
    for (Sample_buffer::Index f = 0; f < scene.number_of_faces(); ++f)
      draw(f);
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_DRAW_FACES_H
