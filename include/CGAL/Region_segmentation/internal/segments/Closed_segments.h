// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_CLOSED_SEGMENTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_CLOSED_SEGMENTS_H

#include <CGAL/Region_segmentation/internal/segments/Segment_caps.h>
#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>

#include <array>
#include <cstddef>
#include <map>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The halfedges of the segments of a mesh, each with its caps: no segment has a border. The first
/// halfedges and vertices are those of the mesh, in their order.
class Closed_segments : public Segmented_halfedges
{
public:
  Closed_segments(const Segmented_halfedges& mesh, const Segment_caps& caps)
    : Segmented_halfedges(mesh)
  {
    m_first_of_caps = mesh.number_of_faces();
    number_of_vertices = caps.points().size();
    for (const Cap_triangle& t : caps.triangles()) {
      add_triangle(t.lower, {t.corners[0], t.corners[1], t.corners[2]});
      add_triangle(t.higher, {t.corners[0], t.corners[2], t.corners[1]});
      m_is_inner.push_back(t.higher <= number_of_segments);
    }
    opposite.resize(size(), none);
    link(mesh.size());
  }

  /// Whether a face belongs to a cap between two segments, not to one on the border of the mesh.
  bool is_between_segments(Index f) const
  {
    return f >= m_first_of_caps && m_is_inner[(f - m_first_of_caps) / 2];
  }

private:
  void add_triangle(Index segment, const std::array<Index, 3>& corners)
  {
    segment_of_face.push_back(segment < number_of_segments ? segment : none);
    face.resize(face.size() + 3, Index(number_of_faces()));
    source.insert(source.end(), corners.begin(), corners.end());
    first.push_back(Index(source.size()));
  }

  /// A halfedge on a border or of a cap, and one of its segment in the other direction, are
  /// opposite.
  void link(std::size_t first_of_caps)
  {
    std::map<std::tuple<Index, Index, Index>, std::vector<Index>> waiting; // segment, source,
                                                                           // target
    for (Index h = 0; h < size(); ++h) {
      if (segment(h) == none || (h < first_of_caps && !is_on_border(h)))
        continue;
      const auto twin = waiting.find({segment(h), target(h), source[h]});
      opposite[h] = none;
      if (twin == waiting.end()) {
        waiting[{segment(h), source[h], target(h)}].push_back(h);
        continue;
      }
      opposite[h] = twin->second.back();
      opposite[twin->second.back()] = h;
      twin->second.pop_back();
      if (twin->second.empty())
        waiting.erase(twin);
    }
  }

  std::size_t m_first_of_caps = 0; // faces
  std::vector<bool> m_is_inner;    // by cap triangle
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_CLOSED_SEGMENTS_H
