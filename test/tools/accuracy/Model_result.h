// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_MODEL_RESULT_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_MODEL_RESULT_H

#include "Measures.h"

#include <cstddef>
#include <optional>
#include <string>

namespace princeton_benchmark {

/// Seconds of CPU time of the stages.
struct Stage_seconds
{
  double reading = 0; ///< the mesh into arrays, where the normals are computed
  double regions = 0; ///< the first ones
  double graph = 0;   ///< of the regions, with its annotation
  double merging = 0; ///< to the labels

  double total() const { return reading + regions + graph + merging; }
};

/// A picture of a result beside one of a truth, as a PNG file.
struct Picture
{
  std::string png;
  std::size_t width = 0, height = 0; ///< in pixels
};

/// What is kept of a model.
struct Model_result
{
  std::string name, category;
  std::string failure; ///< why there is nothing below; empty if there is

  std::size_t number_of_faces = 0, number_of_truths = 0;
  std::size_t wanted_segments = 0;
  std::size_t number_of_segments = 0, number_of_regions = 0; ///< 0 for the method `people`
  Stage_seconds seconds;

  /// The mean over all truths of the result with the wanted number, or with the chosen one where
  /// the method takes none. The members below are of the same result, unless stated otherwise.
  Measures standard;
  /// The same of the number that the method chooses; empty if it cannot.
  std::optional<Measures> automatic;
  std::size_t automatic_segments = 0;
  /// The mean over the truths, each against the result with its own number of segments; empty if
  /// the method takes none.
  std::optional<Measures> own_number;
  /// Against the first of the truths with the wanted number of segments, and against the nearest
  /// one of them by the Rand index; empty if no truth has this number.
  std::optional<Measures> first, nearest;
  std::size_t undefined_cuts = 0; ///< comparisons without a cut discrepancy

  std::string nearest_truth; ///< of all truths, by the Rand index
  double nearest_distance = 0;
  Picture picture; ///< only for a report
};

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_MODEL_RESULT_H
