// SPDX-License-Identifier: GPL-3.0-or-later

#include "published_figures.h"
#include "score_tables.h"

#include <string>

namespace princeton_benchmark {

namespace {

std::size_t distance(std::size_t a, std::size_t b)
{
  return a < b ? b - a : a - b;
}

/// The model of a category with the nearest number of faces, which the paper's may be; null if
/// none.
const Model_result* nearest_model(const Run& run, const Published_time& published)
{
  const Model_result* nearest = nullptr;
  for (const Model_result& r : run.results)
    if (r.failure.empty() && r.category == published.category &&
        (!nearest || distance(r.number_of_faces, published.triangles) <
                       distance(nearest->number_of_faces, published.triangles)))
      nearest = &r;
  return nearest;
}

std::vector<std::string> row(const std::string& name, const std::string& faces,
                             const std::string& segments, const Stage_seconds& s)
{
  return {name,
          faces,
          segments,
          seconds(s.reading),
          seconds(s.regions + s.graph),
          seconds(s.merging),
          seconds(s.total())};
}

Stage_seconds mean_of_stages(const Run& run)
{
  Stage_seconds sum;
  double models = 0;
  for (const Model_result& r : run.results)
    if (r.failure.empty()) {
      ++models;
      sum.reading += r.seconds.reading;
      sum.regions += r.seconds.regions;
      sum.graph += r.seconds.graph;
      sum.merging += r.seconds.merging;
    }
  if (models > 0)
    sum = {sum.reading / models, sum.regions / models, sum.graph / models, sum.merging / models};
  return sum;
}

} // namespace

Table times_table(const Run& run)
{
  Table table{"Seconds of each stage, beside table 2 of the paper",
              {"model", "triangles", "segments", "features", "growing", "merging", "total"},
              {},
              {}};
  for (const Published_time& p : published_times) {
    table.rows.push_back({std::string(p.category) + ", the paper", std::to_string(p.triangles),
                          std::to_string(p.segments), seconds(p.features), seconds(p.growing),
                          seconds(p.merging), seconds(p.total)});
    if (const Model_result* r = nearest_model(run, p))
      table.rows.push_back(row("  model " + r->name + ", " + run.method,
                               std::to_string(r->number_of_faces),
                               std::to_string(r->number_of_segments), r->seconds));
  }
  table.rows.push_back(row("mean of all models, " + run.method, "", "", mean_of_stages(run)));
  table.notes = {
    "The paper's times are of a Pentium of 2.9 GHz; ours of this machine, of the model of "
    "the category with the nearest number of triangles.",
    "The parts of the paper's Octopus sum to 3.600.",
    "Ours: features are reading the mesh into arrays; growing has the feature edges and the graph "
    "of regions, too."};
  return table;
}

} // namespace princeton_benchmark
