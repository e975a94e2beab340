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

/// The faces, nearest first by their nearest corners, where they cover the picture so often that this
/// saves time; else in order.
inline std::vector<Sample_buffer::Index> drawing_order(const Scene& scene,
                                                       const std::vector<Screen_point>& screen,
                                                       const Sample_buffer& buffer)
{
  constexpr double worth_sorting = 32; // times that bounding boxes cover the picture; a closed surface some eight times
  std::vector<Sample_buffer::Index> order(scene.number_of_faces());
  std::iota(order.begin(), order.end(), Sample_buffer::Index(0));
  std::vector<double> depths;
  depths.reserve(order.size());
  double covered = 0;
  for (std::size_t f = 0; f < order.size(); ++f) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Screen_point low = {infinity, infinity, infinity}, high = {-infinity, -infinity, -infinity};
    for (Scene::Index c = scene.first_corners[f]; c < scene.first_corners[f + 1]; ++c) {
      const Screen_point& s = screen[scene.corners[c]];
      low = {(std::min)(low.x, s.x), (std::min)(low.y, s.y), (std::min)(low.depth, s.depth)};
      high = {(std::max)(high.x, s.x), (std::max)(high.y, s.y), (std::max)(high.depth, s.depth)};
    }
    depths.push_back(low.depth);
    if (high.x > low.x && high.y > low.y)
      covered += (high.x - low.x) * (high.y - low.y);
  }
  if (covered > worth_sorting * double(buffer.width()) * double(buffer.height()))
    std::sort(order.begin(), order.end(), [&](Sample_buffer::Index f, Sample_buffer::Index g) {
      return depths[f] != depths[g] ? depths[f] < depths[g] : f < g;
    });
  return order;
}

/// Draws all faces of a scene; `light(c)` is the light at the corner c of `Scene::corners`.
template <typename Light>
void draw_faces(const Scene& scene, const Projection& projection, const Light& light,
                Sample_buffer& buffer)
{
  std::vector<Screen_point> screen;
  screen.reserve(scene.points.size());
  for (const Point& p : scene.points)
    screen.push_back(projection(p));
  std::vector<Sample_buffer::Corner> corners;
  for (const Sample_buffer::Index f : drawing_order(scene, screen, buffer)) {
    corners.clear();
    for (Scene::Index c = scene.first_corners[f]; c < scene.first_corners[f + 1]; ++c) {
      const Screen_point& s = screen[scene.corners[c]];
      corners.push_back({s.x, s.y, s.depth, light(c)});
    }
    buffer.draw_polygon(corners, f);
  }
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_DRAW_FACES_H
