// SPDX-License-Identifier: GPL-3.0-or-later

#include "write_model.h"

#include <cstddef>
#include <ostream>
#include <sstream>

namespace train_merge_cost {

namespace {

constexpr const char* head = R"(// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPERFACETS_INTERNAL_LEARNED_MERGE_MODEL_H
#define CGAL_REGION_SEGMENTATION_SUPERFACETS_INTERNAL_LEARNED_MERGE_MODEL_H

#include <CGAL/Region_segmentation/Superfacets/Merge_model.h>

// Generated; a new training has a new name.
//
)";

constexpr const char* foot = R"(
} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPERFACETS_INTERNAL_LEARNED_MERGE_MODEL_H
)";

/// Breaks a line before it exceeds the width of the package.
class Line_breaker
{
public:
  explicit Line_breaker(std::ostream& out)
    : m_out(out)
  {}

  void add(const std::string& token)
  {
    constexpr std::size_t width = 120;
    if (m_column + token.size() > width) {
      m_out << '\n';
      m_column = 0;
    }
    m_out << token;
    m_column += token.size();
  }

  template <typename Number>
  void add_number(Number number, const char* end)
  {
    add(std::to_string(number) + end);
  }

  void end_line()
  {
    m_out << '\n';
    m_column = 0;
  }

private:
  std::ostream& m_out;
  std::size_t m_column = 0;
};

template <typename Array>
void write_array(Line_breaker& line, const Array& array, const char* end)
{
  line.add("{{");
  for (std::size_t i = 0; i < array.size(); ++i)
    line.add_number(array[i], i + 1 < array.size() ? "," : end);
}

void write_unit(Line_breaker& line, const Model::Unit& unit)
{
  line.add("{" + std::to_string(unit.bias) + "," + std::to_string(unit.output_weight) + ",");
  write_array(line, unit.weights, "}}");
  line.add("},");
  line.end_line();
}

} // namespace

void write_model(std::ostream& out, const Model& trained,
                 const std::vector<std::string>& provenance)
{
  out << head;
  for (const std::string& line : provenance)
    out << "// " << line << '\n';
  out << "\nnamespace CGAL {\nnamespace Region_segmentation {\nnamespace internal {\n\n";
  Line_breaker line(out);
  out << "/// The model of `Learned_merging`.\ninline Merge_model learned_merge_model()\n{\nreturn "
         "{\""
      << trained.name << "\",\n{{\n";
  for (const Model::Input& input : trained.inputs)
    line.add("{" + std::to_string(input.center) + "," + std::to_string(input.factor) + "},");
  line.end_line();
  out << "}},\n{\n";
  for (const Model::Unit& unit : trained.units)
    write_unit(line, unit);
  out << "},\n";
  write_array(line, trained.direct_weights, "}}");
  out << ",\n" << trained.output_bias << "};\n}\n" << foot;
}

} // namespace train_merge_cost
