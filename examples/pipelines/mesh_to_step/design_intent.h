// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_DESIGN_INTENT_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_DESIGN_INTENT_H

#include "part_mesh.h"

#include <cstddef>
#include <string>
#include <vector>

namespace mesh_to_step {

/// What two faces were given: "parallel", "perpendicular", "coaxial", "coplanar", "equal radius" or
/// "tangent".
struct Relation_of_faces
{
  std::string name;
  std::size_t first, second;
};

/// What was changed.
struct Design_log
{
  std::vector<Relation_of_faces> relations;
  std::vector<Fitted_surface> as_found; ///< the surfaces before
};

/// Moves the surfaces of faces so that relations that they have within their errors hold exactly,
/// by least squares: the distances of the vertices stay as small as the relations allow. Relations
/// that contradict others, or with which vertices would be too far from their surfaces, are left.
Design_log set_design_intent(const Mesh& mesh, const Labels& face_of_triangle, Part_faces& faces);

} // namespace mesh_to_step

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_DESIGN_INTENT_H
