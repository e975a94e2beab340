// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PROCEDURAL_MODELS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PROCEDURAL_MODELS_H

#include "models/Labelled_model.h"

#include <string>
#include <vector>

namespace segment_mesh {

/// The same call gives the same model, to the bit.
struct Model_recipe
{
  std::string name;
  Labelled_model (*make_as)(const Making& making);

  Labelled_model make(const Making& making = {}) const { return make_as(making); }
};

/// All models. The first is the one that the program shows without an input.
const std::vector<Model_recipe>& procedural_models();

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PROCEDURAL_MODELS_H
