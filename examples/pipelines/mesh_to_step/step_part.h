// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_STEP_PART_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_STEP_PART_H

#include "make_solid.h"

#include <string>
#include <vector>

namespace mesh_to_step {

/// Whether surfaces are given the relations that they have within their errors.
enum class Design_intent { SET, AS_FOUND };

/// A part as a STEP file.
struct Step_part
{
  std::string text;   ///< of the file, as it was read again
  std::string report; ///< in JSON
  /// Whether what was read is of solids that are closed and valid; each face within a tolerance of
  /// its triangles, and these of it; each edge within 1e-5 of the size of its faces; the volume
  /// that of the mesh; and no face is triangles, unless these are allowed.
  bool is_solid = false;
  std::vector<std::string> remarks; ///< sentences: faces that are facets, what is wrong
};

/// \param mesh of triangles
/// \throws Standard_Failure by OpenCASCADE, and for a part smaller than .001 or larger than 1e12
Step_part make_step_part(Mesh mesh, Facets facets = Facets::REFUSED,
                         Design_intent intent = Design_intent::SET);

} // namespace mesh_to_step

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_STEP_PART_H
