// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SIGNED_DEVIATION_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SIGNED_DEVIATION_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/segments/Halfedge_table.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Whether the surface of a mesh turns a face, since its component is inside out: then its corners
/// run the other way.
inline bool is_turned(const Halfedge_table& mesh, const Surface& surface,
                      Halfedge_table::Index face)
{
  return surface.corner(face, 1) != mesh.target(mesh.first[face]);
}

/// From the source of a halfedge to its target.
inline Double_3 direction(const Halfedge_table& mesh, const Surface& surface,
                          Halfedge_table::Index h)
{
  return surface.point(mesh.target(h)) - surface.point(mesh.source[h]);
}

/// The angle between the two normals of an edge in radians, positive if it is convex and negative
/// if it is concave; 0 beside a degenerate face.
inline double signed_deviation(const Halfedge_table& mesh, const Surface& surface,
                               Halfedge_table::Index h)
{
  const Halfedge_table::Index f = mesh.face[h], g = mesh.face[mesh.opposite[h]];
  if (surface.is_degenerate(f) || surface.is_degenerate(g))
    return 0;
  const Double_3 &n = surface.normal(f), &m = surface.normal(g);
  const double angle = std::acos((std::max)(-1.0, (std::min)(1.0, dot(n, m))));
  const double sign = dot(cross(n, m), direction(mesh, surface, h));
  return (is_turned(mesh, surface, f) ? sign > 0 : sign < 0) ? -angle : angle;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SIGNED_DEVIATION_H
