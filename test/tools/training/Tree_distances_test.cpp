// SPDX-License-Identifier: GPL-3.0-or-later

#include "Tree_distances.h"

#include "cross_validation.h"
#include "models.h"

#include <CGAL/Region_segmentation/Evaluation/overlap_measures.h>
#include <CGAL/Region_segmentation/Superfacets/Learned_merging.h>
#include <CGAL/Region_segmentation/segment.h>

#include <CGAL/IO/OFF.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace train_merge_cost;

namespace {

/// A figure, and its upper and lower half.
const princeton_benchmark::Model& figure()
{
  static const princeton_benchmark::Model model = [] {
    princeton_benchmark::Model result{{}, 6, {{{}, 2}}};
    EXPECT_TRUE(CGAL::IO::read_OFF(TEST_FIGURE, result.soup.points, result.soup.triangles));
    for (const auto& triangle : result.soup.triangles)
      result.people.front().labels.push_back(result.soup.points[triangle[0]].z() > 0);
    return result;
  }();
  return model;
}

template <typename NamedParameters>
double distance_of_segments(const NamedParameters& np)
{
  const auto mesh = princeton_benchmark::make_mesh(figure().soup);
  std::vector<std::uint32_t> labels(num_faces(mesh));
  RS::segment(mesh, princeton_benchmark::face_map(mesh, labels), np);
  return RS::rand_index_distance(labels, figure().people.front().labels);
}

} // namespace

TEST(Tree_distances_test, are_those_of_segment)
{
  const Training_model model = make_training_model(2, figure(), RS::Learned_merging());
  const Tree_distances distances(model, RS::Learned_merging());
  for (const std::size_t k : {1, 2, 6, 20})
    EXPECT_NEAR(distances(k).front(), distance_of_segments(RS::parameters::number_of_segments(k)),
                1e-12)
      << k;
  EXPECT_NEAR(distances(distances.chosen_number()).front(),
              distance_of_segments(RS::parameters::default_values()), 1e-12);
  for (std::size_t k = 1; k <= 100; ++k)
    EXPECT_LE(distances(distances.best_number()).front(), distances(k).front());
}

/// Variants are learned from, in the folds that do not score their model, and are not scored.
TEST(Cross_validation_test, learns_from_variants_with_the_fold_of_their_model)
{
  const auto make = [](int number, std::size_t superfacets) {
    RS::Learned_merging method;
    method.superfacets.number = superfacets;
    return make_training_model(number, figure(), method);
  };
  Training_plan plan;
  plan.noisy_runs = plan.learned_runs = 0;
  plan.options.epochs = 1;
  std::vector<Training_model> models = {make(2, 200), make(4, 200)};
  const Folds folds = {0, 1};
  const Cross_validation alone = cross_validate(models, folds, plan);
  models[0].variants.push_back(make(2, 150));
  const Cross_validation with_variant = cross_validate(models, folds, plan);

  ASSERT_EQ(with_variant.rows.size(), 2u);
  EXPECT_EQ(with_variant.rows[1].features, alone.rows[1].features) << "of the other model";
  const auto &before = alone.rows[0].features, &after = with_variant.rows[0].features;
  ASSERT_GT(after.size(), before.size());
  EXPECT_TRUE(std::equal(before.begin(), before.end(), after.begin()))
    << "then those of the variant";
  EXPECT_EQ(with_variant.trained[0].direct_weights, alone.trained[0].direct_weights)
    << "without the model and its variant";
  EXPECT_NE(with_variant.trained[1].direct_weights, alone.trained[1].direct_weights);
}

/// Furniture of one category is in one fold, and in that of the category of the benchmark.
TEST(Cross_validation_test, furniture_of_one_category_is_learned_from_together)
{
  std::vector<Training_model> models(12);
  const std::vector<const char*> categories = {"Cup",   "Cup",   "Cup",  "Chair", "Chair", "Chair",
                                               "Bench", "Chair", "Desk", "Table", "Chair", "Table"};
  for (std::size_t i = 0; i < models.size(); ++i) {
    models[i].category = categories[i];
    models[i].collection = i < 6 ? "benchmark" : "furniture";
  }
  EXPECT_EQ(folds_of_models(models, 3), (Folds{0, 1, 2, 0, 1, 2, 2, 0, 2, 1, 0, 1}));
  EXPECT_EQ(folds_of_categories(models), (Folds{0, 0, 0, 1, 1, 1, 2, 1, 3, 4, 1, 4}));
}
