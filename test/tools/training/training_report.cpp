// SPDX-License-Identifier: GPL-3.0-or-later

#include "training_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <random>
#include <utility>

namespace train_merge_cost {

using princeton_benchmark::Table;

namespace {

constexpr std::array<const char*, Model::number_of_features> feature_names = {
  "cost",
  "log depth",
  "concave",
  "log area smaller",
  "log area larger",
  "log length larger",
  "log perimeter smaller",
  "log perimeter larger",
  "log perimeter union",
  "thickness step",
  "thickness smaller",
  "thickness larger",
  "section thickness smaller",
  "section thickness larger",
  "thickness deviation union",
  "length for thickness",
  "width for thickness larger",
  "visibility smaller",
  "visibility larger",
  "own visibility smaller",
  "own visibility larger",
  "flatness smaller",
  "flatness union",
  "outward step",
  "distance of centroids",
  "elongation union",
  "roundness union",
  "width union",
  "filling smaller",
  "filling larger",
  "filling of the whole",
  "flatness of the whole",
  "strongly concave of the whole",
  "right angles of the whole",
  "outward of the whole"};
static_assert(feature_names.back() != nullptr, "a name for each feature");

/// A mean, and its standard error.
class Mean
{
public:
  void add(double x)
  {
    if (std::isnan(x))
      return;
    ++m_n;
    m_sum += x;
    m_squares += x * x;
  }
  double mean() const { return m_sum / m_n; }
  double error() const
  {
    return std::sqrt(std::max(0.0, m_squares / m_n - mean() * mean()) / (m_n - 1));
  }

  std::string text() const
  {
    if (m_n == 0)
      return "-";
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%.4f +-%.4f", mean(), error());
    return buffer;
  }

private:
  double m_n = 0, m_sum = 0, m_squares = 0;
};

std::string fixed(double value, int digits)
{
  if (std::isnan(value))
    return "-";
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", digits, value);
  return buffer;
}

double logistic(std::int64_t log_odds)
{
  return 1 / (1 + std::exp(-std::ldexp(double(log_odds), -Model::result_bits)));
}

/// The Kullback-Leibler divergence between two probabilities.
double divergence(double truth, double predicted)
{
  const auto term = [](double a, double b) { return a > 0 ? a * std::log(a / b) : 0; };
  const double p = std::max(1e-9, std::min(1 - 1e-9, predicted));
  return term(truth, p) + term(1 - truth, 1 - p);
}

/// Calls `f(model, rows)` for the rows of each benchmark model and the model trained without it.
template <typename F>
void for_each_out_of_fold(const Cross_validation& validation, const F& f)
{
  for (std::size_t i = 0; i < validation.rows.size(); ++i)
    f(validation.without(i), validation.rows[i]);
}

using Score_member = double Model_score::*;

Mean mean_of(const std::vector<Training_model>& models, bool of_furniture,
             const std::vector<Model_score>& scores, Score_member member)
{
  Mean mean;
  for (std::size_t i = 0; i < models.size(); ++i)
    if (models[i].is_furniture == of_furniture)
      mean.add(scores[i].*member);
  return mean;
}

} // namespace

Table means_table(const std::vector<Training_model>& models, const std::vector<Scored_way>& ways)
{
  Table table{"1 - Rand index, means over the models and their standard errors",
              {"", "k given", "k chosen", "best k in hindsight", "first", "nearest"},
              {},
              {"first, nearest: the paper's protocol"}};
  const auto add_row = [&](const std::string& name, bool of_furniture, const Scored_way& way) {
    std::vector<std::string> row = {name};
    for (Score_member member : {&Model_score::given, &Model_score::automatic, &Model_score::best,
                                &Model_score::first, &Model_score::nearest})
      row.push_back(mean_of(models, of_furniture, *way.scores, member).text());
    table.rows.push_back(row);
  };
  const bool has_furniture = std::any_of(models.begin(), models.end(),
                                         [](const Training_model& m) { return m.is_furniture; });
  for (const Scored_way& way : ways) {
    add_row(way.name, false, way);
    if (has_furniture)
      add_row(way.name + ", furniture", true, way);
  }
  return table;
}

Table category_table(const std::vector<Training_model>& models, const std::vector<Scored_way>& ways)
{
  Table table{"By category: k given / k chosen", {""}, {}, {}};
  for (const Scored_way& way : ways)
    table.header.push_back(way.name);
  std::vector<std::pair<std::string, std::vector<std::size_t>>> members; // models of a category
                                                                         // follow each other
  for (std::size_t i = 0; i < models.size(); ++i) {
    const std::string name = models[i].category + (models[i].is_furniture ? ", furniture" : "");
    if (members.empty() || members.back().first != name)
      members.push_back({name, {}});
    members.back().second.push_back(i);
  }
  for (const auto& [category, indices] : members) {
    std::vector<std::string> row = {category};
    for (const Scored_way& way : ways) {
      Mean given, chosen;
      for (std::size_t i : indices) {
        given.add((*way.scores)[i].given);
        chosen.add((*way.scores)[i].automatic);
      }
      row.push_back(fixed(given.mean(), 3) + " / " + fixed(chosen.mean(), 3));
    }
    table.rows.push_back(row);
  }
  return table;
}

Table calibration_table(const Cross_validation& validation)
{
  constexpr std::size_t bins = 10;
  struct Bin
  {
    double weight = 0, predicted = 0, truth = 0;
  };
  std::array<Bin, bins> all;
  double total = 0;
  for_each_out_of_fold(validation, [&](const Model& model, const Training_rows& rows) {
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const double p = logistic(model(rows.features[r])), w = rows.weights[r];
      Bin& bin = all[std::min(bins - 1, std::size_t(p * bins))];
      bin.weight += w;
      bin.predicted += w * p;
      bin.truth += w * rows.probabilities[r];
      total += w;
    }
  });
  Table table{"Calibration, out of fold, by weight", {"", "share", "predicted", "people"}, {}, {}};
  for (std::size_t i = 0; i < bins; ++i)
    table.rows.push_back({fixed(double(i) / bins, 1) + " ..", fixed(all[i].weight / total, 3),
                          fixed(all[i].predicted / all[i].weight, 3),
                          fixed(all[i].truth / all[i].weight, 3)});
  return table;
}

double mean_loss(const Cross_validation& validation)
{
  double sum = 0, weight = 0;
  for_each_out_of_fold(validation, [&](const Model& model, const Training_rows& rows) {
    for (std::size_t r = 0; r < rows.size(); ++r) {
      sum += rows.weights[r] * divergence(rows.probabilities[r], logistic(model(rows.features[r])));
      weight += rows.weights[r];
    }
  });
  return sum / weight;
}

Table importance_table(const Cross_validation& validation, unsigned seed)
{
  std::array<double, Model::number_of_features> loss{};
  double weight = 0, unchanged = 0;
  std::mt19937 random(seed);
  for_each_out_of_fold(validation, [&](const Model& model, const Training_rows& rows) {
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const double w = rows.weights[r];
      weight += w;
      unchanged += w * divergence(rows.probabilities[r], logistic(model(rows.features[r])));
      // Values come from a row of any model.
      const Training_rows& others = validation.rows[random() % validation.rows.size()];
      const auto& other = others.features[random() % others.size()];
      for (std::size_t i = 0; i < loss.size(); ++i) {
        auto x = rows.features[r];
        x[i] = other[i];
        loss[i] += w * divergence(rows.probabilities[r], logistic(model(x)));
      }
    }
  });
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < loss.size(); ++i)
    order.push_back({(loss[i] - unchanged) / weight, i});
  std::sort(order.rbegin(), order.rend());
  Table table{
    "Importance of features, out of fold: growth of the loss where values are exchanged at random",
    {"", "loss"},
    {},
    {"the loss itself: " + fixed(unchanged / weight, 5)}};
  for (const auto& [growth, i] : order)
    table.rows.push_back({feature_names[i], fixed(growth, 5)});
  return table;
}

} // namespace train_merge_cost
