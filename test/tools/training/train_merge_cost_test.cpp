// SPDX-License-Identifier: GPL-3.0-or-later

#include "Label_counts.h"
#include "Network.h"
#include "Training_rows.h"
#include "write_model.h"

#include <CGAL/Region_segmentation/Evaluation/overlap_measures.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace train_merge_cost;

namespace {

constexpr std::size_t number_of_features = Model::number_of_features;

/// Of random features.
double true_log_odds(const Merge_features::Values& x)
{
  return x[1] / 256.0 - x[2] / 512.0;
}

Training_rows toy_rows(std::size_t n, unsigned seed)
{
  std::mt19937 random(seed);
  Training_rows rows;
  for (std::size_t r = 0; r < n; ++r) {
    Merge_features::Values x;
    for (auto& value : x)
      value = std::int16_t(int(random() % 1024) - 512);
    rows.add(x, 1 / (1 + std::exp(-true_log_odds(x))), 0.5 + double(random() % 100) / 100);
  }
  return rows;
}

template <typename Predict>
double mean_error(const Training_rows& rows, const Predict& predict)
{
  double sum = 0;
  for (const auto& x : rows.features)
    sum += std::abs(std::ldexp(double(predict(x)), -Model::result_bits) - true_log_odds(x));
  return sum / double(rows.size());
}

Model toy_model(const Training_rows& rows, unsigned seed)
{
  Network_options options;
  options.epochs = 20;
  return train_networks(rows, options, seed);
}

} // namespace

TEST(Label_counts_test, distances_are_those_of_the_labels)
{
  for (unsigned seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const std::size_t faces = 200, regions = 20;
    std::vector<std::size_t> region_of;
    std::vector<std::vector<int>> people(3);
    for (std::size_t f = 0; f < faces; ++f) {
      region_of.push_back(f < regions ? f : random() % regions);
      for (auto& labels : people)
        labels.push_back(int(random() % 5));
    }
    Label_counts counts(region_of, regions, people);
    std::vector<double> distances = counts.distances();
    for (std::size_t kept = 0; kept + 1 < regions; ++kept) {
      for (std::size_t i = 0; i < people.size(); ++i)
        EXPECT_NEAR(distances[i], RS::rand_index_distance(region_of, people[i]), 1e-12);
      // The change of the mean distance by a merge, in advance.
      const std::size_t removed = kept + 1;
      const double change = counts.share_of_pairs(removed, kept) *
                            (1 - 2 * counts.probability(removed, kept));
      double before = 0, after = 0;
      for (double d : distances)
        before += d / 3;
      counts.merge(removed, kept);
      for (auto& r : region_of)
        r = r == kept ? removed : r;
      distances = counts.distances();
      for (double d : distances)
        after += d / 3;
      EXPECT_NEAR(after - before, change, 1e-12);
    }
  }
}

TEST(Network_test, the_gradient_is_that_of_the_loss)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<float> any(-1, 1), probability(0, 1);
  Network network(4, 3, 1);
  for (float& p : network.parameters)
    p += 0.3f * any(random);
  Eigen::MatrixXf x(4, 6);
  Eigen::RowVectorXf probabilities(6), weights(6);
  for (int i = 0; i < 6; ++i) {
    probabilities[i] = probability(random);
    weights[i] = probability(random);
    for (int j = 0; j < 4; ++j)
      x(j, i) = any(random);
  }
  const auto loss = [&](const Network& n) {
    const Eigen::RowVectorXf output = n(x);
    double sum = 0;
    for (int i = 0; i < 6; ++i)
      sum += weights[i] * (std::log1p(std::exp(double(output[i]))) - probabilities[i] * output[i]);
    return sum;
  };
  const Eigen::VectorXf gradient = network.gradient(x, probabilities, weights);
  for (int i = 0; i < network.parameters.size(); ++i) {
    const float h = 0.01f;
    Network above = network, below = network;
    above.parameters[i] += h;
    below.parameters[i] -= h;
    EXPECT_NEAR(gradient[i], (loss(above) - loss(below)) / (2 * h), 1e-3) << "parameter " << i;
  }
}

TEST(Network_test, learns_a_slope_in_integers)
{
  const Training_rows rows = toy_rows(4000, 1), others = toy_rows(500, 2);
  const Model network = toy_model(rows, 1);
  const Network_options options;
  EXPECT_EQ(network.units.size(), options.number_of_units * options.number_of_networks);
  EXPECT_LT(mean_error(others, network), 0.25);
  EXPECT_GT(mean_error(others, [](const auto&) { return 0; }), 0.9);
}

TEST(Write_model_test, equal_seeds_give_equal_headers)
{
  const Training_rows rows = toy_rows(500, 1);
  std::ostringstream a, b, c;
  write_model(a, toy_model(rows, 1), {"of toys"});
  write_model(b, toy_model(rows, 1), {"of toys"});
  write_model(c, toy_model(rows, 2), {"of toys"});
  EXPECT_EQ(a.str(), b.str());
  EXPECT_NE(a.str(), c.str());
  EXPECT_NE(a.str().find("// of toys\n"), std::string::npos);
  std::istringstream lines(a.str());
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(line.size(), 120u);
}
