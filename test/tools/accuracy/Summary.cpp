// SPDX-License-Identifier: GPL-3.0-or-later

#include "Summary.h"

#include <algorithm>
#include <numeric>

namespace princeton_benchmark {

namespace {

/// The models of a category, which need not follow each other.
struct Category_sum
{
  std::string name;
  std::size_t number_of_models = 0;
  Mean_measures sum;
};

Category_sum& find_or_add(std::vector<Category_sum>& categories, const std::string& name)
{
  const auto found = std::find_if(categories.begin(), categories.end(),
                                  [&](const Category_sum& c) { return c.name == name; });
  return found != categories.end() ? *found : categories.emplace_back(Category_sum{name, 0, {}});
}

} // namespace

std::optional<Measures> standard_protocol(const Model_result& result)
{
  return result.standard;
}

std::optional<Measures> automatic_protocol(const Model_result& result)
{
  return result.automatic;
}

std::optional<Measures> own_number_protocol(const Model_result& result)
{
  return result.own_number;
}

std::optional<Measures> paper_first_protocol(const Model_result& result)
{
  return result.first;
}

std::optional<Measures> paper_nearest_protocol(const Model_result& result)
{
  return result.nearest;
}

const Category_score* Summary::category(const std::string& name) const
{
  const auto found = std::find_if(categories.begin(), categories.end(),
                                  [&](const Category_score& c) { return c.name == name; });
  return found != categories.end() ? &*found : nullptr;
}

Summary summarize(const std::vector<Model_result>& results, Protocol protocol)
{
  std::vector<Category_sum> categories;
  Mean_measures all;
  Summary summary;
  for (const Model_result& result : results) {
    const std::optional<Measures> measures = protocol(result);
    if (!result.failure.empty() || !measures)
      continue;
    Category_sum& category = find_or_add(categories, result.category);
    ++category.number_of_models;
    category.sum.add(*measures);
    all.add(*measures);
    ++summary.number_of_models;
  }
  Mean_measures of_means;
  for (const Category_sum& category : categories) {
    summary.categories.push_back({category.name, category.number_of_models, category.sum.mean()});
    of_means.add(summary.categories.back().mean);
  }
  summary.over_categories = of_means.mean();
  summary.over_models = all.mean();
  return summary;
}

std::size_t number_of_failures(const std::vector<Model_result>& results)
{
  return std::size_t(std::count_if(results.begin(), results.end(),
                                   [](const Model_result& r) { return !r.failure.empty(); }));
}

std::size_t number_of_undefined_cuts(const std::vector<Model_result>& results)
{
  return std::accumulate(
    results.begin(), results.end(), std::size_t(0),
    [](std::size_t sum, const Model_result& r) { return sum + r.undefined_cuts; });
}

std::size_t number_of_other_numbers(const std::vector<Model_result>& results)
{
  return std::size_t(std::count_if(results.begin(), results.end(), [](const Model_result& r) {
    return r.failure.empty() && r.number_of_segments != r.wanted_segments;
  }));
}

} // namespace princeton_benchmark
