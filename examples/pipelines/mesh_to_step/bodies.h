// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_BODIES_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_BODIES_H

#include "part_mesh.h"

#include <cstddef>
#include <vector>

namespace mesh_to_step {

/// Makes a mesh of triangles whose closed components are the surfaces of bodies and of their voids,
/// of polygons in any order. Where several bodies touch, an edge has four and more polygons: each
/// is joined to the next one through the material. Points that differ by the rounding of single
/// precision become one.
///
/// \throws std::invalid_argument for a polygon that has a point twice
Mesh make_bodies(const std::vector<Point>& points,
                 const std::vector<std::vector<std::size_t>>& polygons);

/// The component of each triangle, and the component that is the outer surface of its body.
struct Bodies
{
  std::vector<std::size_t> component, body;
};

/// Finds the bodies of a closed mesh, and turns components so that normals point out of the
/// material.
Bodies orient_bodies(Mesh& mesh);

} // namespace mesh_to_step

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_BODIES_H
