// SPDX-License-Identifier: GPL-3.0-or-later

#include "score_model.h"

#include "compare_labels.h"
#include "draw_comparison.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace princeton_benchmark {

namespace {

/// The comparisons of one result, and which of them the paper's protocol takes.
class Comparisons
{
public:
  explicit Comparisons(const Model& model)
    : m_model(model)
  {}

  void add(std::size_t truth, const Measures& measures) { m_entries.push_back({truth, measures}); }

  Measures mean() const
  {
    Mean_measures mean;
    for (const Entry& e : m_entries)
      mean.add(e.measures);
    return mean.mean();
  }

  std::size_t undefined_cuts() const
  {
    return std::size_t(std::count_if(m_entries.begin(), m_entries.end(), [](const Entry& e) {
      return std::isnan(e.measures[CUT_DISCREPANCY]);
    }));
  }

  struct Entry
  {
    std::size_t truth;
    Measures measures;

    bool is_nearer_than(const Entry& other) const
    {
      return measures[RAND_INDEX] < other.measures[RAND_INDEX];
    }
  };

  /// \pre there is a comparison
  const Entry& nearest() const
  {
    return *std::min_element(m_entries.begin(), m_entries.end(),
                             [](const Entry& a, const Entry& b) { return a.is_nearer_than(b); });
  }

  /// Null if no truth has the wanted number of segments.
  const Entry* first_of_wanted_number() const
  {
    const auto first = std::find_if(m_entries.begin(), m_entries.end(),
                                    [this](const Entry& e) { return has_wanted_number(e); });
    return first == m_entries.end() ? nullptr : &*first;
  }

  const Entry* nearest_of_wanted_number() const
  {
    const Entry* nearest = nullptr;
    for (const Entry& e : m_entries)
      if (has_wanted_number(e) && (!nearest || e.is_nearer_than(*nearest)))
        nearest = &e;
    return nearest;
  }

private:
  bool has_wanted_number(const Entry& e) const
  {
    return m_model.truths[e.truth].number_of_segments == m_model.number_of_segments;
  }

  const Model& m_model;
  std::vector<Entry> m_entries;
};

Model_result describe(const Model& model)
{
  Model_result result;
  result.number_of_faces = model.soup.polygons.size();
  result.number_of_truths = model.truths.size();
  result.wanted_segments = model.number_of_segments;
  return result;
}

std::optional<Measures> measures_of(const Comparisons::Entry* entry)
{
  return entry ? std::optional<Measures>(entry->measures) : std::nullopt;
}

/// For each truth, its comparisons with the others in their order. All measures are the same, or
/// exchanged, in the other direction: each pair is compared once.
std::vector<Comparisons> compare_all_pairs(const Model& model)
{
  const Benchmark_mesh mesh = make_mesh(model.soup);
  const std::size_t n = model.truths.size();
  std::vector<std::vector<Measures>> pairs(n, std::vector<Measures>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      pairs[i][j] = compare_labels(mesh, model.truths[i].labels, model.truths[j].labels);
      pairs[j][i] = pairs[i][j].exchanged();
    }
  std::vector<Comparisons> result(n, Comparisons(model));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      if (i != j)
        result[i].add(j, pairs[i][j]);
  return result;
}

/// Of several runs the one that took the least time: the labels of all are the same.
Timed_segmentation run_fastest(const Benchmark_mesh& mesh, const Method& method,
                               Wanted_number number, std::size_t runs)
{
  Timed_segmentation fastest = method.segment(mesh, number);
  for (std::size_t i = 1; i < runs; ++i) {
    const Timed_segmentation other = method.segment(mesh, number);
    if (other.seconds.total() < fastest.seconds.total())
      fastest.seconds = other.seconds;
  }
  return fastest;
}

Comparisons compare_with_all(const Model& model, const Benchmark_mesh& mesh,
                             const Timed_segmentation& segmentation)
{
  Comparisons comparisons(model);
  for (std::size_t i = 0; i < model.truths.size(); ++i)
    comparisons.add(i, compare_labels(mesh, segmentation.labels, model.truths[i].labels));
  return comparisons;
}

void add_automatic(const Model& model, const Benchmark_mesh& mesh, const Method& method,
                   Model_result& result)
{
  result.automatic = result.standard;
  result.automatic_segments = result.number_of_segments;
  if (!method.takes_number())
    return;
  const Timed_segmentation segmentation = method.segment(mesh, std::nullopt);
  result.automatic = compare_with_all(model, mesh, segmentation).mean();
  result.automatic_segments = segmentation.number_of_segments;
}

/// The results of a method by their numbers of segments, each made when it is first asked for.
class Results_by_number
{
public:
  Results_by_number(const Method& method, const Benchmark_mesh& mesh)
    : m_method(method)
    , m_mesh(mesh)
  {}

  void add(std::size_t number, const std::vector<int>& labels) { m_labels.emplace(number, labels); }

  const std::vector<int>& labels(std::size_t number)
  {
    const auto found = m_labels.find(number);
    return found != m_labels.end()
             ? found->second
             : m_labels.emplace(number, m_method.segment(m_mesh, number).labels).first->second;
  }

private:
  const Method& m_method;
  const Benchmark_mesh& m_mesh;
  std::map<std::size_t, std::vector<int>> m_labels;
};

Measures mean_of_own_numbers(const Model& model, const Benchmark_mesh& mesh,
                             Results_by_number& results)
{
  Mean_measures mean;
  for (const Truth& truth : model.truths)
    mean.add(compare_labels(mesh, results.labels(truth.number_of_segments), truth.labels));
  return mean.mean();
}

} // namespace

Model_result score_segmentation(const Model& model, const Method& method, const Scoring& scoring)
{
  const Benchmark_mesh mesh = make_mesh(model.soup);
  const Wanted_number wanted = method.takes_number() ? Wanted_number(model.number_of_segments)
                                                     : std::nullopt;
  const Timed_segmentation segmentation = run_fastest(mesh, method, wanted, scoring.runs);
  const Comparisons comparisons = compare_with_all(model, mesh, segmentation);

  Model_result result = describe(model);
  result.number_of_segments = segmentation.number_of_segments;
  result.number_of_regions = segmentation.number_of_regions;
  result.seconds = segmentation.seconds;
  result.standard = comparisons.mean();
  result.first = measures_of(comparisons.first_of_wanted_number());
  result.nearest = measures_of(comparisons.nearest_of_wanted_number());
  result.undefined_cuts = comparisons.undefined_cuts();
  if (method.chooses_number())
    add_automatic(model, mesh, method, result);
  if (method.takes_number()) {
    Results_by_number results(method, mesh);
    results.add(model.number_of_segments, segmentation.labels);
    result.own_number = mean_of_own_numbers(model, mesh, results);
  }
  const Comparisons::Entry& nearest = comparisons.nearest();
  result.nearest_truth = model.truths[nearest.truth].name;
  result.nearest_distance = nearest.measures[RAND_INDEX];
  if (scoring.pictures == Pictures::NEAREST_TRUTH)
    result.picture = draw_comparison(model.soup, segmentation.labels,
                                     model.truths[nearest.truth].labels);
  return result;
}

Model_result score_people(const Model& model)
{
  if (model.truths.size() < 2)
    throw std::runtime_error("one human segmentation alone has no other to be compared with");
  // The first person of the wanted number is the truth for the others, and no result.
  const auto has_wanted_number = [&](const Truth& truth) {
    return truth.number_of_segments == model.number_of_segments;
  };
  const std::size_t first_person = std::size_t(
    std::find_if(model.truths.begin(), model.truths.end(), has_wanted_number) -
    model.truths.begin());

  Mean_measures standard, first, nearest;
  Model_result result = describe(model);
  const std::vector<Comparisons> people = compare_all_pairs(model);
  for (std::size_t i = 0; i < people.size(); ++i) {
    standard.add(people[i].mean());
    result.undefined_cuts += people[i].undefined_cuts();
    if (const auto* entry = people[i].first_of_wanted_number(); entry && i != first_person)
      first.add(entry->measures);
    if (const auto* entry = people[i].nearest_of_wanted_number())
      nearest.add(entry->measures);
  }
  result.standard = standard.mean();
  if (first_person < model.truths.size()) {
    result.first = first.mean();
    result.nearest = nearest.mean();
  }
  return result;
}

} // namespace princeton_benchmark
