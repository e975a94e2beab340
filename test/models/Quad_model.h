// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_QUAD_MODEL_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_QUAD_MODEL_H

#include "models/Labelled_model.h"

namespace segment_mesh {

/// Which of its two diagonals splits a quad.
enum class Diagonals {
  FIRST,       ///< that of its first corner
  ALTERNATING, ///< of the first corner, then of the second, in the order of the faces
  AT_RANDOM    ///< the same at each call
};

/// Splits each quad into two triangles of the same part.
void split_quads(Labelled_model& model, Diagonals diagonals);

/// Moves each point at random, by up to `amount` along each axis; the same at each call.
void add_noise(Labelled_model& model, double amount);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_QUAD_MODEL_H
