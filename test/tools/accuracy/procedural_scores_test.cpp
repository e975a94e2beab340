// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the methods stand on the models that need no data: a change that makes one worse is seen.

#include "run_benchmark.h"
#include "score_model.h"

#include <gtest/gtest.h>

#include <iterator>
#include <string>

namespace princeton_benchmark {

namespace {

/// The most that the Rand index distance to the true parts may be, with their number given: what it
/// was, and a margin for the rounding of other compilers.
struct Bound
{
  const char* model;
  double learned, visibility, two_step;
};

constexpr Bound bounds[] = {{"articulated_figure", 0.010, 0.010, 0.010},
                            {"vase", 0.010, 0.010, 0.010},
                            {"goblet", 0.010, 0.010, 0.010},
                            {"snowman", 0.010, 0.010, 0.010},
                            {"shaft", 0.010, 0.010, 0.010},
                            {"screwdriver", 0.010, 0.010, 0.010},
                            {"table", 0.010, 0.010, 0.010},
                            {"chair", 0.049, 0.251, 0.084},
                            {"bracket", 0.062, 0.036, 0.029},
                            {"gear", 0.063, 0.160, 0.277},
                            {"mug", 0.010, 0.010, 0.010},
                            {"hammer", 0.018, 0.018, 0.015},
                            {"octopus", 0.010, 0.010, 0.010},
                            {"hand", 0.027, 0.022, 0.021},
                            {"quadruped", 0.016, 0.017, 0.017}};

class Procedural : public testing::TestWithParam<const char*>
{};

TEST_P(Procedural, is_as_close_to_the_true_parts_as_it_was)
{
  const std::string name = GetParam();
  const Method& method = find_method(name);
  const auto bound = name == "learned"      ? &Bound::learned
                     : name == "visibility" ? &Bound::visibility
                                            : &Bound::two_step;
  const auto score = [&method](const Model& model) { return score_segmentation(model, method); };
  const auto results = run_benchmark(procedural_sources(), score, 2, [](std::size_t) {});
  ASSERT_EQ(results.size(), std::size(bounds));
  for (std::size_t i = 0; i < results.size(); ++i) {
    EXPECT_EQ(results[i].name, bounds[i].model);
    EXPECT_EQ(results[i].failure, "");
    EXPECT_EQ(results[i].number_of_segments, results[i].wanted_segments) << results[i].name;
    EXPECT_LE(results[i].standard[RAND_INDEX], bounds[i].*bound) << results[i].name;
  }
}

INSTANTIATE_TEST_SUITE_P(Scores, Procedural, testing::Values("learned", "visibility", "two-step"),
                         [](const auto& info) {
                           return std::string(info.param) == "two-step" ? "two_step"
                                                                        : std::string(info.param);
                         });

} // namespace

} // namespace princeton_benchmark
