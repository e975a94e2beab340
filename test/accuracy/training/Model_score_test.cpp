// SPDX-License-Identifier: GPL-3.0-or-later

#include "Model_score.h"

#include "Benchmark_mesh.h"
#include "model_sources.h"

#include <CGAL/Region_segmentation/Methods/Learned_merging.h>
#include <CGAL/Region_segmentation/Methods/Superfacets.h>
#include <CGAL/Region_segmentation/evaluation/rand_index_distance.h>
#include <CGAL/Region_segmentation/segment.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace RS = CGAL::Region_segmentation;
using namespace train_merge_cost;

namespace {

/// The first model and its known parts.
const princeton_benchmark::Model& procedural_model()
{
  static const princeton_benchmark::Model model = princeton_benchmark::procedural_sources().front().load();
  return model;
}

template <typename NamedParameters>
double distance_of_segments(const NamedParameters& np)
{
  const auto mesh = princeton_benchmark::make_mesh(procedural_model().soup);
  std::vector<std::uint32_t> labels(num_faces(mesh));
  RS::segment(mesh, princeton_benchmark::face_map(mesh, labels), np);
  return RS::rand_index_distance(labels, procedural_model().truths.front().labels);
}

} // namespace

TEST(Model_score_test, is_that_of_segment)
{
  const std::size_t k = procedural_model().number_of_segments;
  const Training_model model = make_training_model(2, procedural_model(), RS::Superfacets().number, RS::Learned_merging::few);
  const Model_score score = score_learned(model, RS::internal::learned_merge_model);
  EXPECT_NEAR(score.given, distance_of_segments(RS::parameters::number_of_segments(k)), 1e-12);
  EXPECT_NEAR(score.automatic, distance_of_segments(RS::parameters::default_values()), 1e-12);
  EXPECT_NEAR(score.first, score.given, 1e-12) << "there is one person";
  EXPECT_NEAR(score.nearest, score.given, 1e-12);
  EXPECT_LE(score.best, score.given + 1e-12);
}
