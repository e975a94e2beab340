// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_ACCURACY_SCORE_MODEL_H
#define CGAL_REGION_SEGMENTATION_TEST_ACCURACY_SCORE_MODEL_H

#include "Model_result.h"
#include "model_sources.h"
#include "segment_with.h"

namespace princeton_benchmark {

enum class Pictures
{
  NONE,
  NEAREST_TRUTH
};

/// Runs a method with the model's number of segments, and compares its result with all truths.
/// Fills all but the names. \throws std::exception
Model_result score_segmentation(const Model& model, Segmenter segmenter, Pictures pictures);

/// Compares each truth with all others. The standard protocol's score is the mean over the pairs.
/// In the paper's protocol each truth is a result, compared with the first, and with the nearest,
/// of the others that have the wanted number of segments; their means are taken. \throws
/// std::exception
Model_result score_people(const Model& model);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_ACCURACY_SCORE_MODEL_H
