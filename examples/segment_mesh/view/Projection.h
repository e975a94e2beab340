// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PROJECTION_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PROJECTION_H

#include "soup/vector_algebra.h"
#include "view/Scene.h"
#include "view/Viewpoint.h"

#include <algorithm>
#include <limits>

namespace segment_mesh {

/// A point of the picture: in samples from its top left corner; less depth is nearer.
struct Screen_point
{
  double x, y, depth;
};

/// Parallel projection of a scene into a picture. Depth has the unit of the scene, whose radius
/// is 1.
class Projection
{
public:
  /// One `scale`, in samples per unit, for all viewpoints.
  Projection(const Viewpoint& viewpoint, double width, double height, double scale)
    : m_viewpoint(viewpoint)
    , m_scale(scale)
    , m_offset_x(width / 2)
    , m_offset_y(height / 2)
  {}

  /// As large as it fits, with a `margin` as a part of width and height.
  Projection(const Scene& scene, const Viewpoint& viewpoint, double width, double height,
             double margin)
    : Projection(viewpoint, width, height, 1)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double low_x = infinity, low_y = infinity, high_x = -infinity, high_y = -infinity;
    for (std::size_t i = 0; i < scene.points.size(); ++i) {
      if (!scene.is_used[i])
        continue;
      const double x = inner_product(scene.points[i], viewpoint.right);
      const double y = -inner_product(scene.points[i], viewpoint.up);
      low_x = (std::min)(low_x, x);
      low_y = (std::min)(low_y, y);
      high_x = (std::max)(high_x, x);
      high_y = (std::max)(high_y, y);
    }
    if (!(high_x > low_x) && !(high_y > low_y)) // nothing, or a point
      return;
    const double room = 1 - 2 * margin;
    m_scale = room * (std::min)(width / (high_x - low_x), height / (high_y - low_y));
    m_offset_x = width / 2 - m_scale * (low_x + high_x) / 2;
    m_offset_y = height / 2 - m_scale * (low_y + high_y) / 2;
  }

  Screen_point operator()(const Point& p) const
  {
    return {m_offset_x + m_scale * inner_product(p, m_viewpoint.right),
            m_offset_y - m_scale * inner_product(p, m_viewpoint.up),
            -inner_product(p, m_viewpoint.toward_viewer)};
  }

private:
  Viewpoint m_viewpoint;
  double m_scale, m_offset_x, m_offset_y;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PROJECTION_H
