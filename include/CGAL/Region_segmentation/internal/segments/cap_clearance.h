// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_CAP_CLEARANCE_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_CAP_CLEARANCE_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/segments/Closed_segments.h>
#include <CGAL/Region_segmentation/internal/segments/Halfedge_table.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The planes of the faces around a vertex of a solid, weighted by the angles of their corners:
/// those of caps that move inwards, those of other faces that stay.
class Planes_of_vertex
{
public:
  void add(const Double_3& normal, double angle, bool moves)
  {
    m_rows[0] = m_rows[0] + angle * normal.x * normal;
    m_rows[1] = m_rows[1] + angle * normal.y * normal;
    m_rows[2] = m_rows[2] + angle * normal.z * normal;
    m_angle += angle;
    if (moves)
      m_sum = m_sum - angle * normal;
  }

  /// The shortest move that takes the vertex to all planes, in the sense of least squares, those of
  /// caps being moved inwards by a distance: by conjugate gradients, which end at a direction to
  /// which the planes are nearly parallel, so no vertex of a wedge moves far.
  Double_3 move(double distance) const
  {
    Double_3 result{0, 0, 0}, residual = m_sum, direction = m_sum;
    for (int i = 0; i < 3; ++i) {
      const Double_3 product{dot(m_rows[0], direction), dot(m_rows[1], direction),
                             dot(m_rows[2], direction)};
      const double curvature = dot(direction, product);
      if (!(curvature > least_share * m_angle * squared_norm(direction)))
        break;
      const double step = squared_norm(residual) / curvature;
      const Double_3 next = residual - step * product;
      result = result + step * direction;
      direction = next + squared_norm(next) / squared_norm(residual) * direction;
      residual = next;
    }
    return distance * result;
  }

private:
  static constexpr double least_share = 0.02; // that of the sides of a wedge of 16 degrees

  std::array<Double_3, 3> m_rows = {Double_3{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}; // normal equations
  Double_3 m_sum{0, 0, 0};
  double m_angle = 0;
};

/// The area vector of a face by Newell's formula, relative to its first corner. `points`: by source
inline Double_3 area_vector(const Halfedge_table& mesh, Halfedge_table::Index face,
                            const std::vector<Double_3>& points)
{
  const Halfedge_table::Index first = mesh.first[face], end = mesh.first[face + 1];
  const Double_3 origin = points[mesh.source[first]];
  Double_3 sum{0, 0, 0};
  for (Halfedge_table::Index h = first + 2; h < end; ++h)
    sum = sum + cross(points[mesh.source[h - 1]] - origin, points[mesh.source[h]] - origin);
  return 0.5 * sum;
}

/// The moves of the vertices of solids that leave a clearance between the caps of two of them: by
/// the halfedge that leaves the vertex. `points`: by source
inline std::vector<Double_3> moves_for_clearance(const Closed_segments& solids,
                                                 const std::vector<Double_3>& points,
                                                 double clearance)
{
  using Index = Halfedge_table::Index;
  const Partition fans = solids.fans();
  std::vector<Planes_of_vertex> planes(fans.number_of_parts());
  for (Index f = 0; f < solids.number_of_faces(); ++f) {
    const Double_3 area = area_vector(solids, f, points);
    if (!(norm(area) > 0))
      continue;
    for (Index h = solids.first[f]; h < solids.first[f + 1]; ++h) {
      const Index corner = solids.next(h);
      const Double_3 back = points[solids.source[h]] - points[solids.source[corner]];
      const Double_3 ahead = points[solids.target(corner)] - points[solids.source[corner]];
      planes[fans[corner]].add(1 / norm(area) * area,
                               std::atan2(norm(cross(ahead, back)), dot(ahead, back)),
                               solids.is_between_segments(f));
    }
  }
  std::vector<Double_3> of_fans, result;
  for (const Planes_of_vertex& p : planes)
    of_fans.push_back(p.move(0.5 * clearance));
  for (Index h = 0; h < solids.size(); ++h)
    result.push_back(of_fans[fans[h]]);
  return result;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_CAP_CLEARANCE_H
