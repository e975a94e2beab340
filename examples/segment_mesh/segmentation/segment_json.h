// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENT_JSON_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENT_JSON_H

#include "segmentation/Segmentation_details.h"

#include <nlohmann/json_fwd.hpp>

namespace segment_mesh {

/// The shape of a segment as an object, see doc/Region_segmentation/Program.txt; values that are
/// not finite are null.
nlohmann::ordered_json segment_json(const Segment_description& segment);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENT_JSON_H
