// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_MESH_GEOMETRY_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_MESH_GEOMETRY_H

#include <CGAL/Region_segmentation/internal/segments/Halfedge_table.h>
#include <CGAL/Region_segmentation/make_surface.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Lengths, areas and signed angles of a mesh, by the numbers of a `Halfedge_table`. Components
/// that `make_surface()` turns, since they are inside out, are turned here, too.
class Mesh_geometry
{
public:
  using Index = Halfedge_table::Index;

  Mesh_geometry(const Halfedge_table& halfedges, Surface surface)
    : m_halfedges(halfedges)
    , m_surface(std::move(surface))
  {}

  const Surface& surface() const { return m_surface; }
  /// Of lengths and points, as a multiple of that of the mesh.
  double unit() const { return m_surface.unit(); }
  const Double_3& point(Index vertex) const { return m_surface.point(vertex); }
  /// Zero for a degenerate face.
  const Double_3& normal(Index face) const { return m_surface.normal(face); }

  /// The normal of a face as it is given, not turned.
  Double_3 given_normal(Index face) const { return double(orientation(face)) * normal(face); }

  /// -1 for a face that is turned, otherwise 1: the corners of a turned one run the other way.
  int orientation(Index face) const
  {
    return m_surface.corner(face, 1) == m_halfedges.target(m_halfedges.first[face]) ? 1 : -1;
  }

  Double_3 direction(Index h) const
  {
    return point(m_halfedges.target(h)) - point(m_halfedges.source[h]);
  }
  double length(Index h) const { return norm(direction(h)); }

  /// The angle between the two normals of an edge in radians, positive if it is convex and negative
  /// if it is concave; 0 beside a degenerate face.
  double signed_deviation(Index h) const
  {
    const Index f = m_halfedges.face[h];
    const Double_3 &n = normal(f), &m = normal(m_halfedges.face[m_halfedges.opposite[h]]);
    if (squared_norm(n) == 0 || squared_norm(m) == 0)
      return 0;
    const double angle = std::acos((std::max)(-1.0, (std::min)(1.0, dot(n, m))));
    const double sign = orientation(f) * dot(cross(n, m), direction(h));
    return sign < 0 ? -angle : angle;
  }

private:
  const Halfedge_table& m_halfedges;
  const Surface m_surface;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_MESH_GEOMETRY_H
