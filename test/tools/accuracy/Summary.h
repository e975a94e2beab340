// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_SUMMARY_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_SUMMARY_H

#include "Model_result.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace princeton_benchmark {

/// Which scores of a model a protocol takes; empty leaves the model out.
using Protocol = std::optional<Measures> (*)(const Model_result&);

/// One result a model against every truth.
std::optional<Measures> standard_protocol(const Model_result& result);
/// The same with the number of segments that the method chooses.
std::optional<Measures> automatic_protocol(const Model_result& result);
/// Each truth against the result that has as many segments as it.
std::optional<Measures> own_number_protocol(const Model_result& result);
/// Against the first truth with the most common number of segments.
std::optional<Measures> paper_first_protocol(const Model_result& result);
/// Against the nearest of these.
std::optional<Measures> paper_nearest_protocol(const Model_result& result);

struct Category_score
{
  std::string name;
  std::size_t number_of_models;
  Measures mean;
};

/// Means in one protocol, of the models that did not fail.
struct Summary
{
  std::vector<Category_score> categories; ///< in the order of the models
  Measures over_categories;               ///< the mean of the categories' means
  Measures over_models;
  std::size_t number_of_models = 0;

  /// Null if no model of it was scored.
  const Category_score* category(const std::string& name) const;
};

Summary summarize(const std::vector<Model_result>& results, Protocol protocol);

/// \name Numbers of all results
/// @{
std::size_t number_of_failures(const std::vector<Model_result>& results);
std::size_t number_of_undefined_cuts(const std::vector<Model_result>& results);
/// Models whose result has not the wanted number of segments.
std::size_t number_of_other_numbers(const std::vector<Model_result>& results);
/// @}

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_SUMMARY_H
