// SPDX-License-Identifier: GPL-3.0-or-later
//
// The runner on models so small that their scores are counted by hand.

#include "Summary.h"
#include "draw_comparison.h"
#include "run_benchmark.h"
#include "score_model.h"
#include "write_csv.h"
#include "write_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>

namespace princeton_benchmark {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A cube of six quads.
segment_mesh::Polygon_soup make_cube()
{
  segment_mesh::Polygon_soup soup;
  for (std::size_t i = 0; i < 8; ++i)
    soup.points.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  soup.polygons = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                   {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  return soup;
}

/// Pairs of faces within a segment: 4, 6 and 10 of 15; in two truths: always the same 4 (0 1, 0 2,
/// 1 2, 3 4). So 4 + 6 - 2 * 4 = 2 differ between the truths 0 and 1, 6 between 0 and 2, 8 between
/// 1 and 2. The wanted number of segments is 2, which 1 and 2 have.
Model make_model()
{
  Model model;
  model.soup = make_cube();
  model.number_of_segments = 2;
  model.truths = {
    {"m_0", {0, 0, 0, 1, 1, 2}, 3}, {"m_1", {0, 0, 0, 1, 1, 1}, 2}, {"m_2", {0, 0, 0, 0, 0, 1}, 2}};
  return model;
}

/// Like the second truth; of three segments like the first one, of a number of its own like the
/// third.
Timed_segmentation segment_like_truths(const Benchmark_mesh&, Wanted_number number)
{
  Timed_segmentation result;
  result.number_of_segments = number.value_or(2);
  const std::vector<Truth> truths = make_model().truths;
  result.labels = truths[!number ? 2 : *number == 3 ? 0 : 1].labels;
  return result;
}

const Method like_truths{"like truths", segment_like_truths, Numbers::BOTH};

Model_result make_result(const std::string& name, const std::string& category, double rand_index)
{
  Model_result result;
  result.name = name;
  result.category = category;
  result.standard.values.fill(rand_index);
  result.first = result.nearest = result.standard;
  return result;
}

double rand_index(const std::optional<Measures>& measures)
{
  return measures ? (*measures)[RAND_INDEX] : nan;
}

} // namespace

TEST(Score_model, compares_with_all_truths_and_with_those_of_the_wanted_number)
{
  const Model_result r = score_segmentation(make_model(), like_truths);
  EXPECT_NEAR(r.standard[RAND_INDEX], (2. / 15 + 0 + 8. / 15) / 3, 1e-15);
  EXPECT_EQ(rand_index(r.first), 0);
  EXPECT_EQ(rand_index(r.nearest), 0);
  EXPECT_EQ(r.nearest_truth, "m_1");
  EXPECT_TRUE(r.picture.png.empty());
}

TEST(Score_model, the_first_truth_of_the_wanted_number_need_not_be_the_nearest)
{
  Model model = make_model();
  std::reverse(model.truths.begin(), model.truths.end());
  const Model_result r = score_segmentation(model, like_truths);
  EXPECT_NEAR(rand_index(r.first), 8. / 15, 1e-15);
  EXPECT_EQ(rand_index(r.nearest), 0);
}

TEST(Score_model, a_model_without_a_truth_of_the_wanted_number_is_not_in_the_papers_protocol)
{
  Model model = make_model();
  model.number_of_segments = 5;
  EXPECT_FALSE(score_segmentation(model, like_truths).first);
  EXPECT_FALSE(score_people(model).nearest);
}

TEST(Score_model, the_chosen_number_and_those_of_the_truths_have_scores_of_their_own)
{
  const Model_result both = score_segmentation(make_model(), like_truths);
  EXPECT_NEAR(rand_index(both.automatic), (6. / 15 + 8. / 15 + 0) / 3, 1e-15);
  EXPECT_NEAR(rand_index(both.own_number), (0 + 0 + 8. / 15) / 3, 1e-15);

  const Model_result given = score_segmentation(make_model(),
                                                {"", segment_like_truths, Numbers::GIVEN});
  EXPECT_FALSE(given.automatic);
  EXPECT_EQ(rand_index(given.own_number), rand_index(both.own_number));

  const Model_result chosen = score_segmentation(make_model(),
                                                 {"", segment_like_truths, Numbers::CHOSEN});
  EXPECT_FALSE(chosen.own_number);
  EXPECT_EQ(rand_index(chosen.automatic), rand_index(both.automatic));
  EXPECT_EQ(chosen.standard[RAND_INDEX], rand_index(both.automatic));
}

TEST(Score_model, people_are_compared_with_each_other)
{
  const Model_result r = score_people(make_model());
  const double d01 = 2. / 15, d02 = 6. / 15, d12 = 8. / 15;
  EXPECT_NEAR(r.standard[RAND_INDEX], (d01 + d02 + d12) / 3, 1e-15);
  EXPECT_NEAR(rand_index(r.first), (d01 + d12) / 2, 1e-15); // the truth is person 1
  EXPECT_NEAR(rand_index(r.nearest), (d01 + d12 + d12) / 3, 1e-15);
  EXPECT_NEAR(r.standard[MISSING_RATE], r.standard[FALSE_ALARM_RATE], 1e-15);

  Model alone = make_model();
  alone.truths.resize(1);
  EXPECT_THROW(score_people(alone), std::runtime_error);
}

TEST(Run_benchmark, keeps_the_order_and_every_failure)
{
  std::vector<Model_source> sources;
  for (int i = 0; i < 60; ++i)
    sources.push_back({std::to_string(i), "category", [i] {
                         if (i % 7 == 3)
                           throw std::runtime_error("no " + std::to_string(i));
                         return make_model();
                       }});
  const auto score = [](const Model& model) { return score_segmentation(model, like_truths); };
  for (std::size_t threads : {1, 2, 7, 100}) {
    std::size_t latest = 0;
    const auto results = run_benchmark(sources, score, threads,
                                       [&](std::size_t done) { EXPECT_EQ(done, ++latest); });
    EXPECT_EQ(latest, sources.size());
    ASSERT_EQ(results.size(), sources.size());
    for (std::size_t i = 0; i < results.size(); ++i) {
      EXPECT_EQ(results[i].name, std::to_string(i));
      EXPECT_EQ(results[i].failure, i % 7 == 3 ? "no " + std::to_string(i) : "");
    }
    EXPECT_EQ(number_of_failures(results), 9u);
  }
}

TEST(Run_benchmark, reads_the_layout_of_the_benchmark_and_tells_of_a_bad_file)
{
  namespace fs = std::filesystem;
  const fs::path root = fs::temp_directory_path() /
                        ("princeton_" + std::to_string(std::random_device()()));
  for (const char* folder :
       {"data/off", "data/seg/Benchmark/1", "data/seg/Benchmark/2", "util/parameters"})
    fs::create_directories(root / folder);
  for (const char* mesh : {"data/off/1.off", "data/off/2.off"})
    std::ofstream(root / mesh) << "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                  "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  std::ofstream(root / "data/seg/Benchmark/1/1_0.seg") << "0\n0\n1\n1\n";
  std::ofstream(root / "data/seg/Benchmark/2/2_0.seg") << "0\n0\n1\n";
  std::ofstream(root / "util/parameters/nSeg-ByModel.txt") << "2\n2\n";

  const Princeton_data data(root);
  const auto results = run_benchmark(
    princeton_sources(data),
    [](const Model& model) { return score_segmentation(model, find_method("two-step")); }, 1,
    [](std::size_t) {});
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].failure, "");
  EXPECT_EQ(results[0].category, "Human");
  EXPECT_EQ(results[0].wanted_segments, 2u);
  EXPECT_NE(results[1].failure.find("2_0.seg"), std::string::npos);
  fs::remove_all(root);
}

TEST(Furniture_sources, are_models_with_a_label_for_each_face_by_name)
{
  namespace fs = std::filesystem;
  const fs::path root = fs::temp_directory_path() /
                        ("furniture_" + std::to_string(std::random_device()()));
  fs::create_directories(root);
  EXPECT_THROW(furniture_sources(root), std::runtime_error) << "there is none";
  constexpr std::size_t faces = 1000;
  for (const std::string name : {"Table_b", "Chair_a_1"}) {
    std::ofstream mesh(root / (name + ".off")), labels(root / (name + ".seg"));
    mesh << "OFF\n3 " << faces << " 0\n0 0 0\n1 0 0\n0 1 0\n";
    for (std::size_t f = 0; f < faces; ++f) {
      mesh << "3 0 1 2\n";
      labels << (f < 2 ? 7 : f < 5 ? 5 : 0) << '\n'; // .2 %, .3 %, and the rest
    }
  }
  std::ofstream(root / "Table_b.seg", std::ios::app) << "0\n"; // one too many

  const std::vector<Model_source> sources = furniture_sources(root);
  ASSERT_EQ(sources.size(), 2u);
  EXPECT_EQ(sources[0].name, "Chair_a_1");
  EXPECT_EQ(sources[0].category, "Chair");
  EXPECT_EQ(sources[1].category, "Table");
  const Model model = sources[0].load();
  EXPECT_EQ(model.number_of_segments, 2u) << "the part of .2 % does not count";
  ASSERT_EQ(model.truths.size(), 1u);
  EXPECT_EQ(model.truths[0].number_of_segments, 3u);
  EXPECT_EQ(model.truths[0].labels.size(), faces);
  EXPECT_THROW(sources[1].load(), std::runtime_error);
  fs::remove_all(root);
}

TEST(Summary, takes_means_of_models_then_of_categories)
{
  std::vector<Model_result> results = {make_result("1", "a", 0.1), make_result("2", "b", 0.5),
                                       make_result("3", "a", 0.3), make_result("4", "b", 9),
                                       make_result("5", "a", 0.8)};
  results[3].failure = "failed";
  results[4].first.reset();
  const Summary standard = summarize(results, standard_protocol);
  EXPECT_NEAR(standard.category("a")->mean[RAND_INDEX], 0.4, 1e-15);
  EXPECT_NEAR(standard.over_categories[RAND_INDEX], 0.45, 1e-15);
  EXPECT_NEAR(standard.over_models[RAND_INDEX], 1.7 / 4, 1e-15);
  EXPECT_EQ(standard.number_of_models, 4u);
  EXPECT_EQ(standard.category("c"), nullptr);
  const Summary first = summarize(results, paper_first_protocol);
  EXPECT_NEAR(first.category("a")->mean[RAND_INDEX], 0.2, 1e-15);
  EXPECT_EQ(first.number_of_models, 3u);
}

TEST(Summary, an_undefined_score_is_in_no_mean)
{
  std::vector<Model_result> results = {make_result("1", "a", 0.2), make_result("2", "a", 0.4)};
  results[1].standard.values[CUT_DISCREPANCY] = nan;
  const Summary summary = summarize(results, standard_protocol);
  EXPECT_EQ(summary.over_categories[CUT_DISCREPANCY], 0.2);
  EXPECT_NEAR(summary.over_categories[RAND_INDEX], 0.3, 1e-15);
}

TEST(Match_labels, largest_common_parts_first_and_each_name_once)
{
  const std::vector<int> result = {0, 0, 0, 1, 1, 2};
  EXPECT_EQ(match_labels(result, {7, 7, 7, -4, -4, 5}),
            (std::vector<std::size_t>{0, 0, 0, 1, 1, 2}));
  EXPECT_EQ(match_labels(result, {7, 7, 8, 8, 8, 8}), (std::vector<std::size_t>{0, 0, 1, 1, 1, 1}));
  EXPECT_EQ(match_labels(result, {1, 2, 3, 4, 4, 4})[3], 1u);
  const auto names = match_labels(result, {1, 2, 3, 4, 5, 6});
  EXPECT_EQ(std::set<std::size_t>(names.begin(), names.end()).size(), 6u);
}

TEST(Write_csv, every_line_has_all_fields)
{
  std::vector<Model_result> results = {make_result("1", "a", 0.25), make_result("2", "a", 0.5)};
  results[0].first.reset();
  results[1].failure = "a \"word\" and another";
  std::ostringstream out;
  write_csv(out, results);
  std::istringstream lines(out.str());
  std::size_t number_of_lines = 0;
  for (std::string line; std::getline(lines, line); ++number_of_lines)
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), 59) << line;
  EXPECT_EQ(number_of_lines, 3u);
  EXPECT_NE(out.str().find("\"a \"\"word\"\" and another\""), std::string::npos);
}

TEST(Write_report, needs_no_other_file_and_has_the_worst_first)
{
  const Model_result drawn = score_segmentation(make_model(), like_truths,
                                                {Pictures::NEAREST_TRUTH});
  princeton_benchmark::Run run{"two-step", true, Numbers::GIVEN, {drawn, drawn, drawn}};
  run.results[0].name = "good";
  run.results[1].name = "bad";
  run.results[1].standard.values[RAND_INDEX] = 0.9;
  run.results[2].name = "<broken>";
  run.results[2].failure = "a & b";
  run.results[2].picture = {};
  std::ostringstream out;
  write_report(out, run);
  const std::string html = out.str();
  EXPECT_LT(html.find("<b> bad</b>"), html.find("<b> good</b>"));
  EXPECT_NE(html.find("&lt;broken&gt; (): a &amp; b"), std::string::npos);
  EXPECT_NE(html.find("src=\"data:image/png;base64,iVBORw0KGgo"), std::string::npos);
  for (const char* outside : {"http://", "https://", "src=\"/", "url("})
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
}

} // namespace princeton_benchmark
