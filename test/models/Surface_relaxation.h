// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_SURFACE_RELAXATION_H
#define CGAL_REGION_SEGMENTATION_TEST_SURFACE_RELAXATION_H

#include "models/Implicit_shape.h"
#include "soup/Polygon_soup.h"

namespace segment_mesh {

/// Improves the shapes of triangles on an implicit surface. The number of points and triangles, and
/// the topology, stay.
class Surface_relaxation
{
public:
  /// `soup`: a closed oriented manifold of triangles near the surface; is changed
  Surface_relaxation(const Implicit_shape& shape, Polygon_soup& soup, double edge_length);

  /// Makes edges locally Delaunay: flips those whose opposite angles sum to more than pi, each
  /// triangle once at most.
  void flip_edges();

  /// Moves each point to the mean of its neighbors, and back to the surface.
  void move_points();

private:
  Point projected(Point p) const;

  const Implicit_shape& m_shape;
  Polygon_soup& m_soup;
  double m_edge_length;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_TEST_SURFACE_RELAXATION_H
