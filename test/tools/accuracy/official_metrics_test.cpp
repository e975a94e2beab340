// SPDX-License-Identifier: GPL-3.0-or-later
//
// Our four measures against the benchmark's own evaluator, on pairs of human segmentations. The
// data is not part of the package. It is found by two environment variables:
//   REGION_SEGMENTATION_PSB          the directory that holds the benchmark's data/ and util/
//   REGION_SEGMENTATION_PSB_METRICS  the table of what the evaluator printed for each pair

#include "Princeton_data.h"

#include <CGAL/Region_segmentation/Evaluation/evaluation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace RS = CGAL::Region_segmentation;

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Face = Mesh::Face_index;

constexpr std::size_t number_of_columns = 9;
using Measures = std::array<double, number_of_columns>;

constexpr std::array<const char*, number_of_columns> column_names = {
  "rand_index", "cut_discrepancy", "hamming", "missing_rate", "false_alarm_rate", "gce",
  "lce",        "gce_area",        "lce_area"};

/// A line of the table.
struct Row
{
  int model = 0, a = 0, b = 0;
  Measures measures{};
};

std::vector<Row> read_table(std::istream& in)
{
  std::string line, expected = "model\tsegmentation_a\tsegmentation_b";
  for (const char* name : column_names)
    expected += std::string("\t") + name;
  std::getline(in, line);
  EXPECT_EQ(line, expected);

  std::vector<Row> rows;
  while (std::getline(in, line)) {
    std::istringstream fields(line);
    Row row;
    fields >> row.model >> row.a >> row.b;
    for (double& value : row.measures)
      fields >> value;
    EXPECT_TRUE(fields) << line;
    rows.push_back(row);
  }
  return rows;
}

/// The evaluator divides by F (F - 1) / 2 with an integer division of F - 1 by 2, so for even F it
/// prints 1 - RI times this.
double evaluator_factor(std::size_t number_of_faces)
{
  const std::size_t n = number_of_faces - 1;
  return (double(n) / 2) / double(n / 2);
}

Mesh read_mesh(const Princeton_data& data, int model)
{
  Mesh mesh;
  std::ifstream in(data.mesh_file(model));
  EXPECT_TRUE(CGAL::IO::read_OFF(in, mesh)) << data.mesh_file(model);
  return mesh;
}

Mesh::Property_map<Face, int> label_map(Mesh& mesh, const std::vector<int>& labels,
                                        const std::string& name)
{
  auto map = mesh.add_property_map<Face, int>(name).first;
  std::size_t i = 0;
  for (Face f : faces(mesh))
    put(map, f, labels[i++]);
  return map;
}

Measures measure(const Princeton_data& data, const Row& row)
{
  Mesh mesh = read_mesh(data, row.model);
  const std::size_t n = num_faces(mesh);
  const auto a = label_map(mesh, data.labels(row.model, row.a, n), "f:a");
  const auto b = label_map(mesh, data.labels(row.model, row.b, n), "f:b");

  const double rand = RS::rand_index_distance(mesh, a, b);
  const RS::Hamming_distance hamming = RS::hamming_distance(mesh, a, b);
  const RS::Consistency_error error = RS::consistency_error(mesh, a, b);
  const std::optional<double> cut = RS::cut_discrepancy(mesh, a, b);
  EXPECT_TRUE(cut.has_value());
  return {rand * evaluator_factor(n), cut.value_or(-1), hamming.distance, hamming.missing_rate,
          hamming.false_alarm_rate,   error.global,     error.local,      error.global_by_area,
          error.local_by_area};
}

TEST(Official_metrics, every_column_of_every_pair_is_within_1e_4)
{
  const std::optional<Princeton_data> data = Princeton_data::from_environment();
  const char* table = std::getenv("REGION_SEGMENTATION_PSB_METRICS");
  std::ifstream in;
  if (table)
    in.open(table);
  if (!data)
    GTEST_SKIP() << "REGION_SEGMENTATION_PSB does not name the unpacked Princeton benchmark";
  if (!in.is_open())
    GTEST_SKIP() << "REGION_SEGMENTATION_PSB_METRICS does not name the evaluator's table";

  constexpr double tolerance = 1e-4;
  constexpr double zero = 1e-12; // the evaluator prints its rounding errors where we have 0
  Measures worst{};
  const std::vector<Row> rows = read_table(in);
  EXPECT_FALSE(rows.empty());
  for (const Row& row : rows) {
    const Measures ours = measure(*data, row);
    for (std::size_t c = 0; c < number_of_columns; ++c) {
      const double theirs = row.measures[c];
      const double difference = std::abs(ours[c] - theirs);
      EXPECT_LE(difference, tolerance * std::abs(theirs) + zero)
        << column_names[c] << " of model " << row.model << ", people " << row.a << " and " << row.b
        << ": " << ours[c] << ", the evaluator says " << theirs;
      if (difference > zero)
        worst[c] = (std::max)(worst[c], difference / std::abs(theirs));
    }
  }
  RecordProperty("pairs", std::to_string(rows.size()));
  for (std::size_t c = 0; c < number_of_columns; ++c) {
    std::ostringstream value;
    value << worst[c];
    RecordProperty(std::string("worst_relative_deviation_") + column_names[c], value.str());
  }
}

} // namespace
