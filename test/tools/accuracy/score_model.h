// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_SCORE_MODEL_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_SCORE_MODEL_H

#include "Model_result.h"
#include "model_sources.h"
#include "segment_with.h"

namespace princeton_benchmark {

enum class Pictures { NONE, NEAREST_TRUTH };

struct Scoring
{
  Pictures pictures = Pictures::NONE;
  std::size_t runs = 1; ///< the times are those of the fastest; at least 1
};

/// Runs a method with the model's number of segments, with the number that the method chooses, and
/// with that of each truth, as far as it can, and compares the results with the truths. Fills all
/// but the names. \throws std::exception
Model_result score_segmentation(const Model& model, const Method& method,
                                const Scoring& scoring = {});

/// Compares each truth with all others. The standard protocol's score is the mean over the pairs.
/// In the paper's protocol each truth is a result, compared with the first, and with the nearest,
/// of the others that have the wanted number of segments; their means are taken. \throws
/// std::exception
Model_result score_people(const Model& model);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_SCORE_MODEL_H
