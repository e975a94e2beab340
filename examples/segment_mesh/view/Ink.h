// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_INK_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_INK_H

#include "view/Projection.h"
#include "view/Sample_buffer.h"
#include "view/Scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace segment_mesh {

/// The dark lines on a picture: how much of a sample's color they take. None is on the background.
class Ink
{
public:
  explicit Ink(const Sample_buffer& buffer)
    : m_buffer(buffer)
    , m_darkness(buffer.width() * buffer.height())
  {}

  /// Where two neighboring samples show different segments: borders, and outlines of one segment
  /// before another. `radius` in samples; `darkness` from 0 to 255.
  void draw_borders(const Scene& scene, double radius, std::uint8_t darkness);

  /// Lines on the surface, where no face is before them.
  void draw_edges(const Scene& scene, const Projection& projection,
                  const std::vector<Vertex_pair>& edges, double radius, std::uint8_t darkness);

  std::uint8_t darkness(std::size_t sample) const { return m_darkness[sample]; }

private:
  struct Offset
  {
    std::ptrdiff_t x, y;
  };

  static std::vector<Offset> disc(double radius);
  void stamp(std::size_t x, std::size_t y, const std::vector<Offset>& disc, std::uint8_t darkness);
  bool is_visible(std::size_t x, std::size_t y, double depth) const;
  void draw_line(const Screen_point& from, const Screen_point& to, const std::vector<Offset>& disc,
                 std::uint8_t darkness);

  const Sample_buffer& m_buffer;
  std::vector<std::uint8_t> m_darkness;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_INK_H
