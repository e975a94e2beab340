// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_WRITE_MODEL_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_WRITE_MODEL_H

#include "Network.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace train_merge_cost {

/// Writes a model as the header `learned_merge_model.h` of the library. `provenance`: lines of a
/// comment
void write_model(std::ostream& out, const Model& trained,
                 const std::vector<std::string>& provenance);

} // namespace train_merge_cost

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_WRITE_MODEL_H
