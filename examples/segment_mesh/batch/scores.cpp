// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch/scores.h"

#include "read/Text_scanner.h"
#include "read/errors.h"
#include "read/load_bytes.h"
#include "segmentation/Manifold.h"

#include <CGAL/Region_segmentation/Evaluation/evaluation.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>

namespace segment_mesh {

namespace {

namespace RS = CGAL::Region_segmentation;

using Mesh = Manifold::Mesh;

constexpr std::size_t number_of_measures = 5;
constexpr const char* names[number_of_measures] = {"Rand index distance", "cut discrepancy",
                                                   "Hamming distance", "global consistency error",
                                                   "local consistency error"};

/// The cut discrepancy is not defined where a side has no cut.
using Scores = std::array<std::optional<double>, number_of_measures>;

Scores compare(const Mesh& mesh, const std::vector<std::size_t>& labels,
               const std::vector<std::int64_t>& truth)
{
  const auto a = face_map(mesh, labels);
  const auto b = face_map(mesh, truth);
  const RS::Consistency_error consistency = RS::consistency_error(mesh, a, b);
  return {RS::rand_index_distance(mesh, a, b), RS::cut_discrepancy(mesh, a, b),
          RS::hamming_distance(mesh, a, b).distance, consistency.global, consistency.local};
}

Scores mean(const std::vector<Scores>& all)
{
  Scores result;
  for (std::size_t m = 0; m < number_of_measures; ++m) {
    double sum = 0;
    std::size_t count = 0;
    for (const Scores& scores : all)
      if (scores[m]) {
        sum += *scores[m];
        ++count;
      }
    if (count > 0)
      result[m] = sum / double(count);
  }
  return result;
}

std::string line(const std::string& name, const Scores& scores)
{
  std::string text = "  " + one_line(name) + ":";
  for (std::size_t m = 0; m < number_of_measures; ++m) {
    char value[32] = "undefined";
    if (scores[m])
      std::snprintf(value, sizeof value, "%.4f", *scores[m]);
    text += std::string(m == 0 ? " " : ", ") + names[m] + " " + value;
  }
  return text + "\n";
}

} // namespace

Truth read_truth(const std::string& file, std::size_t number_of_faces)
{
  constexpr std::size_t longest_line = 21; // a label is an integer of 64 bits
  const std::string bytes = load_bytes(file,
                                       (std::max)(harmless_size, longest_line * number_of_faces));
  return parse_truth(file, bytes, number_of_faces);
}

Truth parse_truth(const std::string& name, std::string_view bytes, std::size_t number_of_faces)
{
  Text_scanner scan(name, bytes, '#');
  Truth truth{name, {}};
  while (scan.next_line()) {
    truth.labels.push_back(scan.integer(scan.word(), "a label"));
    if (scan.has_word())
      scan.fail("more than one label on a line");
  }
  if (truth.labels.size() != number_of_faces)
    throw Input_error(name, counted(truth.labels.size(), "label") + " for " +
                              counted(number_of_faces, "face"));
  return truth;
}

std::string describe_scores(const Input_mesh& input,
                            const std::vector<std::size_t>& segment_of_face,
                            const std::vector<Truth>& truths)
{
  if (truths.empty())
    return {};
  const Manifold manifold = make_manifold(input.soup);
  const std::vector<std::size_t> labels = manifold.values_of_mesh_faces(segment_of_face);
  std::string text;
  std::vector<Scores> all;
  for (const Truth& truth : truths) {
    all.push_back(compare(manifold.mesh, labels, manifold.values_of_mesh_faces(truth.labels)));
    text += line(truth.name, all.back());
  }
  return truths.size() > 1 ? text + line("mean", mean(all)) : text;
}

} // namespace segment_mesh
