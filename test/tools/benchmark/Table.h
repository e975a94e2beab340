// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_TABLE_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_TABLE_H

#include "Case.h"
#include "Measurement.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace speed_benchmark {

/// Words about the whole run: name, value.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// The numbers of a line, by column, in their order; nothing where a column does not apply.
/// Times are ns a face, memory is bytes a face.
using Numbers = std::vector<std::pair<std::string, std::optional<double>>>;
Numbers numbers(const Case& c, std::size_t number_of_faces, const Measurement& measurement);

/// The table, as `STEM.csv` and `STEM.md`.
class Table
{
public:
  /// \throws std::runtime_error if the files cannot be written
  Table(std::string stem, Facts facts);

  void add_line(const Case& c, const Numbers& numbers);
  /// Writes all lines so far: a long run that is broken off leaves what it has.
  /// \throws std::runtime_error if a file cannot be written
  void write(const Facts& facts_at_end = {}) const;

private:
  using Cells = std::vector<std::string>;

  std::string csv(const Facts& facts) const;
  std::string markdown(const Facts& facts) const;

  std::string m_stem;
  Facts m_facts;
  Cells m_head;
  std::vector<Cells> m_lines;
};

} // namespace speed_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_TABLE_H
