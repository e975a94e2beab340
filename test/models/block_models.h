// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_BLOCK_MODELS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_BLOCK_MODELS_H

#include "models/Labelled_model.h"

namespace segment_mesh {

/// \name Surfaces of blocks on a grid, which may be bent
/// @{
Labelled_model make_table(const Making& making); ///< a top and four legs
Labelled_model make_chair(const Making& making); ///< seat, back and four legs, splayed; with noise
Labelled_model make_bracket(const Making& making); ///< two plates at a right angle, and a boss;
                                                   ///< with noise
Labelled_model make_gear(const Making& making); ///< a ring with eight teeth, and a hub; with noise
/// @}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_BLOCK_MODELS_H
