// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_IMPLICIT_MODELS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_IMPLICIT_MODELS_H

#include "models/Labelled_model.h"

namespace segment_mesh {

/// \name Soft unions of simple bodies
/// @{
Labelled_model make_mug(const Making& making);     ///< a cup and its handle
Labelled_model make_hammer(const Making& making);  ///< head and handle
Labelled_model make_octopus(const Making& making); ///< a head and eight arms
Labelled_model make_hand(const Making& making);    ///< a palm, four fingers and a thumb; with noise
Labelled_model make_quadruped(const Making& making); ///< trunk, head, tail and four legs; coarse
/// @}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_IMPLICIT_MODELS_H
