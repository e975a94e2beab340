// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_REVOLUTION_MODELS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_REVOLUTION_MODELS_H

#include "models/Labelled_model.h"

namespace segment_mesh {

/// \name Surfaces of revolution
/// @{
Labelled_model make_vase(const Making& making);    ///< foot, belly and neck; of quads
Labelled_model make_goblet(const Making& making);  ///< foot, stem and a hollow bowl; with noise
Labelled_model make_snowman(const Making& making); ///< three balls; with noise
Labelled_model make_shaft(const Making& making); ///< with two collars and a thinner journal; coarse
Labelled_model make_screwdriver(const Making& making); ///< handle and shank; long triangles
/// @}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_REVOLUTION_MODELS_H
