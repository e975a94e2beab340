// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SAMPLE_BUFFER_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SAMPLE_BUFFER_H

#include "view/Scene.h"
#include "view/Viewpoint.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace segment_mesh {

/// The nearest face at each sample of a picture, and the light on it there.
class Sample_buffer
{
public:
  using Index = Scene::Index;

  static constexpr Index no_face = (std::numeric_limits<Index>::max)();

  /// A corner of a polygon: in samples from the top left corner of the picture; less depth is
  /// nearer.
  struct Corner
  {
    double x, y, depth, light;
  };

  Sample_buffer(std::size_t width, std::size_t height);

  std::size_t width() const { return m_width; }
  std::size_t height() const { return m_height; }

  /// Draws the samples whose centers are inside the polygon, by the even-odd rule, so it need not
  /// be convex. Depth and light are interpolated along its sides, then along rows. Faces that share
  /// a side leave no gap and do not overlap. Of equal depths the lower face stays, so the order of
  /// drawing does not matter.
  void draw_polygon(const std::vector<Corner>& corners, Index face);

  Index face(std::size_t sample) const { return m_faces[sample]; }
  float depth(std::size_t sample) const { return m_depths[sample]; }
  float light(std::size_t sample) const { return m_lights[sample]; }

private:
  /// Where a row of samples crosses a side.
  struct Crossing
  {
    double x, depth, light;
  };

  void find_crossings(const std::vector<Corner>& corners, double y);
  void draw_span(const Crossing& from, const Crossing& to, std::size_t row, Index face);

  std::size_t m_width, m_height;
  std::vector<Index> m_faces;
  std::vector<float> m_depths;
  std::vector<float> m_lights;
  std::vector<Crossing> m_crossings; // of the row at hand
};

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
             double margin);

  Screen_point operator()(const Point& p) const;

private:
  Viewpoint m_viewpoint;
  double m_scale, m_offset_x, m_offset_y;
};

/// Draws all faces of a scene; `light(c)` is the light at the corner c of `Scene::corners`.
template <typename Light>
void draw_faces(const Scene& scene, const Projection& projection, const Light& light,
                Sample_buffer& buffer)
{
  std::vector<Sample_buffer::Corner> corners;
  for (Scene::Index f = 0; f < scene.number_of_faces(); ++f) {
    corners.clear();
    for (Scene::Index c = scene.first_corners[f]; c < scene.first_corners[f + 1]; ++c) {
      const Screen_point s = projection(scene.points[scene.corners[c]]);
      corners.push_back({s.x, s.y, s.depth, light(c)});
    }
    buffer.draw_polygon(corners, f);
  }
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SAMPLE_BUFFER_H
