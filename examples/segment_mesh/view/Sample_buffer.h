// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SAMPLE_BUFFER_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SAMPLE_BUFFER_H

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace segment_mesh {

/// The nearest face at each sample of a picture, and the light on it there.
class Sample_buffer
{
public:
  using Index = std::uint32_t;

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
  /// drawing does not matter. What lies behind whole blocks of samples takes next to no time.
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

  static constexpr std::size_t samples_of_block = 32; // in a row

  void find_crossings(const std::vector<Corner>& corners, double y);
  void draw_span(const Crossing& from, const Crossing& to, std::size_t row, Index face);
  void bound_block(std::size_t row, std::size_t block);

  std::size_t m_width, m_height, m_blocks_of_row;
  std::vector<Index> m_faces;
  std::vector<float> m_depths;
  std::vector<float> m_farthest; // by row and block: no sample has a greater depth
  std::vector<float> m_lights;
  std::vector<Crossing> m_crossings; // of the row at hand
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SAMPLE_BUFFER_H
