// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_DRAW_FACES_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_DRAW_FACES_H

#include "view/Projection.h"
#include "view/Sample_buffer.h"
#include "view/Scene.h"

#include <cstddef>
#include <vector>

namespace segment_mesh {

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
  for (std::size_t f = 0; f < scene.number_of_faces(); ++f) {
    corners.clear();
    for (Scene::Index c = scene.first_corners[f]; c < scene.first_corners[f + 1]; ++c) {
      const Screen_point& s = screen[scene.corners[c]];
      corners.push_back({s.x, s.y, s.depth, light(c)});
    }
    buffer.draw_polygon(corners, Sample_buffer::Index(f));
  }
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_DRAW_FACES_H
