// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_MESH_GEOMETRY_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_MESH_GEOMETRY_H

#include <CGAL/Region_segmentation/internal/segments/Halfedge_table.h>
#include <CGAL/Region_segmentation/internal/support/Lowest_root_forest.h>
#include <CGAL/Region_segmentation/make_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

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
    , m_orientations(halfedges.number_of_faces(), 1)
  {
    Lowest_root_forest components(halfedges.number_of_faces());
    for (Index h = 0; h < halfedges.size(); ++h)
      if (halfedges.opposite[h] != Halfedge_table::none)
        components.unite(halfedges.face[h], halfedges.face[halfedges.opposite[h]]);
    for (Index f = 0; f < m_orientations.size(); ++f)
      if (dot(area_vector_of_corners(f), m_surface.normal(f)) < 0)
        m_orientations[components.root(f)] = -1;
    for (Index f = 0; f < m_orientations.size(); ++f)
      m_orientations[f] = m_orientations[components.root(f)];
  }

  const Surface& surface() const { return m_surface; }
  /// Of lengths and points, as a multiple of that of the mesh.
  double unit() const { return m_surface.unit(); }
  const Double_3& point(Index vertex) const { return m_surface.point(vertex); }
  /// Zero for a degenerate face.
  const Double_3& normal(Index face) const { return m_surface.normal(face); }

  /// The normal of a face as it is given, not turned.
  Double_3 given_normal(Index face) const { return double(m_orientations[face]) * normal(face); }

  /// -1 for a face that is turned, otherwise 1.
  int orientation(Index face) const { return m_orientations[face]; }
  /// Of length area, also of a degenerate face.
  Double_3 area_vector(Index face) const
  {
    return double(m_orientations[face]) * area_vector_of_corners(face);
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
    const double sign = m_orientations[f] * dot(cross(n, m), direction(h));
    return sign < 0 ? -angle : angle;
  }

private:
  Double_3 area_vector_of_corners(Index face) const
  {
    return internal::area_vector(m_halfedges, face, [&](Index v) { return point(v); });
  }

  const Halfedge_table& m_halfedges;
  const Surface m_surface;
  std::vector<signed char> m_orientations; // by face
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_MESH_GEOMETRY_H
