// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_REPORT_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_REPORT_H

#include "check_solid.h"
#include "design_intent.h"

#include <string>

namespace mesh_to_step {

/// "cylinder_3", of the face of that number.
std::string face_name(const Part_faces& faces, std::size_t face);

/// In JSON: the solids as a whole, the faces with their surfaces and errors, a table of holes, and
/// fillets by radius.
std::string report(const Part_faces& faces, const Design_log& log, const Solid& solid,
                   const Certificate& certificate, bool is_right);

} // namespace mesh_to_step

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_REPORT_H
