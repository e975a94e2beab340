// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_VOLUMES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_VOLUMES_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/segments/Segment_caps.h>
#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>
#include <CGAL/Region_segmentation/internal/segments/signed_deviation.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The volume of each segment with its caps, and at the end that of the faces without a segment.
/// They add up to the volume of the mesh.
///
/// By the divergence theorem, as the sum of the tetrahedra from a point of the segment to its
/// triangles.
inline std::vector<double> segment_volumes(const Segmented_halfedges& mesh, const Surface& surface)
{
  using Index = Halfedge_table::Index;
  std::vector<Double_3> points;
  for (Index v = 0; v < mesh.number_of_vertices; ++v)
    points.push_back(surface.point(v));
  const Segment_caps caps(mesh, std::move(points),
                          [&](Index f) { return is_turned(mesh, surface, f); });
  std::vector<double> volumes(mesh.number_of_segments + 1, 0);
  std::vector<Index> origins(volumes.size(), Halfedge_table::none); // vertices
  const auto add = [&](std::size_t segment, const std::array<Index, 3>& corners, int orientation) {
    const Double_3 origin = caps.points()[origins[segment]];
    const Double_3 a = caps.points()[corners[0]] - origin, b = caps.points()[corners[1]] - origin,
                   c = caps.points()[corners[2]] - origin;
    volumes[segment] += orientation * dot(a, cross(b, c)) / 6;
  };
  for (Index f = 0; f < mesh.number_of_faces(); ++f) {
    const Index first = mesh.source[mesh.first[f]];
    const std::size_t segment = caps.numbered(mesh.segment_of_face[f]);
    if (origins[segment] == mesh.none)
      origins[segment] = first;
    for (Index h = mesh.first[f] + 2; h < mesh.first[f + 1]; ++h)
      add(segment, {first, mesh.source[h - 1], mesh.source[h]},
          is_turned(mesh, surface, f) ? -1 : 1);
  }
  for (const Cap_triangle& t : caps.triangles()) {
    add(t.lower, t.corners, 1);
    if (t.higher < volumes.size()) // not beyond the border of the mesh
      add(t.higher, t.corners, -1);
  }
  return volumes;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_VOLUMES_H
