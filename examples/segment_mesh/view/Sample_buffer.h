// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SAMPLE_BUFFER_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SAMPLE_BUFFER_H

#include "view/Scene.h"
#include "view/choose_viewpoint.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace segment_mesh {

/// A point of a picture: in samples from its top left corner; less depth is nearer.
struct Screen_point
{
  double x, y, depth, light;
};

/// A depth buffer: the nearest face at each sample of a picture, and the light on it there.
class Sample_buffer
{
public:
  using Index = Polygons::Index;

  static constexpr Index no_face = (std::numeric_limits<Index>::max)();

  struct Sample
  {
    Index face = no_face;
    float depth = std::numeric_limits<float>::infinity();
    float light = 0;
    bool is_inked = false; ///< by a dark line
  };

  Sample_buffer(std::size_t width, std::size_t height);

  std::size_t width() const { return m_width; }
  std::size_t height() const { return m_height; }

  const Sample& at(std::size_t column, std::size_t row) const
  {
    return m_samples[row * m_width + column];
  }

  /// Draws the samples whose centers are inside the polygon, by the even-odd rule, so it need not
  /// be convex. Depth and light are interpolated along its sides, then along rows. Faces that share
  /// a side leave no gap and do not overlap. Of equal depths the lower face stays, so the order of
  /// drawing does not matter.
  void draw_polygon(const std::vector<Screen_point>& corners, Index face);

  /// Calls `f(sample)` for those within a distance of one that show a face.
  template <typename Function>
  void for_each_near(std::size_t column, std::size_t row, double distance, const Function& f)
  {
    const std::ptrdiff_t reach = std::ptrdiff_t(distance);
    for (std::ptrdiff_t dy = -reach; dy <= reach; ++dy)
      for (std::ptrdiff_t dx = -reach; dx <= reach; ++dx) {
        const std::size_t x = column + std::size_t(dx), y = row + std::size_t(dy);
        if (double(dx * dx + dy * dy) <= distance * distance && x < m_width &&
            y < m_height && // also not before the first one
            at(x, y).face != no_face)
          f(m_samples[y * m_width + x]);
      }
  }

private:
  void find_crossings(const std::vector<Screen_point>& corners, double y);
  void draw_span(const Screen_point& from, const Screen_point& to, std::size_t row, Index face);

  std::size_t m_width, m_height;
  std::vector<Sample> m_samples;
  std::vector<Screen_point> m_crossings; // of the row at hand with the sides of a polygon
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

  Screen_point operator()(const Point& p, double light = 0) const;

private:
  Viewpoint m_viewpoint;
  double m_scale, m_offset_x, m_offset_y;
};

/// Draws all faces of a scene; `light(f, p)` is the light at the corner of the face f at the
/// point p.
template <typename Light>
void draw_faces(const Scene& scene, const Projection& projection, const Light& light,
                Sample_buffer& buffer)
{
  std::vector<Screen_point> corners;
  for (std::size_t f = 0; f < scene.labels.size(); ++f) {
    corners.clear();
    for (const std::size_t p : scene.soup.polygons[f])
      corners.push_back(projection(scene.soup.points[p], light(f, p)));
    buffer.draw_polygon(corners, Sample_buffer::Index(f));
  }
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SAMPLE_BUFFER_H
