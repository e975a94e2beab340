// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_SPEED_SHAPES_H
#define CGAL_REGION_SEGMENTATION_TEST_SPEED_SHAPES_H

// Shapes on which a method without care takes quadratic time: hubs, overlapping components, far
// outliers. Each has about the given number of faces.

#include "make_mesh.h"

#include <cstddef>

namespace shapes {

using speed_benchmark::Mesh;

/// A smooth cone, its faces around one vertex.
Mesh cone(std::size_t faces);
/// The same in folds: a crease at every edge.
Mesh folded_cone(std::size_t faces);
/// A polygon of half as many corners as faces, and a triangle at each of its edges.
Mesh star(std::size_t faces);
/// Triangles that do not touch, through the same segment in space.
Mesh triangles_at_one_edge(std::size_t faces);
/// Polygons of three to eight of the same ten points.
Mesh polygons_on_ten_points(std::size_t faces);
/// Small tetrahedra at random.
Mesh tetrahedra(std::size_t faces);
/// A strip of triangles in zigzag folds.
Mesh folded_strip(std::size_t faces);
/// A torus, and a triangle of its size a million diameters away.
Mesh torus_and_far_triangle(std::size_t faces);

} // namespace shapes

#endif // CGAL_REGION_SEGMENTATION_TEST_SPEED_SHAPES_H
