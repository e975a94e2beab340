// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_DESIGN_INTENT_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_DESIGN_INTENT_H

#include "part_mesh.h"

#include <cstddef>
#include <string>
#include <vector>

namespace mesh_to_step {

/// What two faces were given: "parallel", "perpendicular", "coaxial", "coplanar", "equal radius" or
/// "tangent"; or a round number, in units of the mesh or degrees: "distance" or "angle", of one
/// face "radius", "major radius" or "half angle".
struct Relation_of_faces
{
  std::string name;
  std::size_t first, second; ///< equal if it is of one face
  double from = 0, to = 0;   ///< of a round number, which is not 0

  bool is_round_number() const { return to != 0; }
};

/// What was changed.
struct Design_log
{
  std::vector<Relation_of_faces> relations;
  std::vector<Fitted_surface> as_found; ///< the surfaces before
};

/// Moves the surfaces of faces so that relations that they have within their errors hold exactly,
/// by least squares: the distances of the vertices stay as small as the relations allow. Lengths
/// become multiples of .01, and angles of .5 degrees, where the errors are less than a tenth of
/// these. Relations that contradict others, round numbers first, or with which vertices would be
/// too far from their surfaces, are left.
Design_log set_design_intent(const Mesh& mesh, const Labels& face_of_triangle, Part_faces& faces);

} // namespace mesh_to_step

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_DESIGN_INTENT_H
