// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENT_JSON_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENT_JSON_H

#include "segmentation/Segmentation_details.h"

#include <nlohmann/json_fwd.hpp>

namespace segment_mesh {

/// \name The words for them in outputs
/// @{
const char* name_of(CGAL::Region_segmentation::Surface_kind kind);
const char* name_of(CGAL::Region_segmentation::Face_role role);
/// @}

/// Whether a surface is a sphere, a cylinder or a torus.
bool has_radius(const CGAL::Region_segmentation::Fitted_surface<Kernel>& s);

/// The surface of the face that a segment is, else the simple one that fits best; `point` of a cone
/// is its apex.
CGAL::Region_segmentation::Fitted_surface<Kernel> surface_of(const Segment_description& segment);

/// The largest distance of a vertex to the surface of a face, else the root mean square distance.
double error_of(const Segment_description& segment);

/// The shape of a segment as an object, see io/write_json.cpp; values that are not finite are null.
nlohmann::ordered_json segment_json(const Segment_description& segment);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENT_JSON_H
