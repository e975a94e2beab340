// SPDX-License-Identifier: GPL-3.0-or-later

#include "Table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace speed_benchmark {

namespace {

/// Three digits that count, and every digit before the point.
std::string text(double value)
{
  const int digits_before = value == 0 ? 1 : int(std::floor(std::log10(std::abs(value)))) + 1;
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f",
                value == std::floor(value) ? 0 : std::max(0, 3 - digits_before), value);
  return buffer;
}

void write_file(const std::string& file, const std::string& content)
{
  std::ofstream out(file, std::ios::binary);
  if (!(out << content << std::flush))
    throw std::runtime_error(file + " could not be written");
}

template <typename Quote>
std::string joined(const std::vector<std::string>& cells, const char* between, const Quote& quote)
{
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i)
    line += (i == 0 ? "" : between) + quote(cells[i]);
  return line;
}

std::string as_it_is(const std::string& cell)
{
  return cell;
}

/// None of the texts has quotation marks in it.
std::string quoted(const std::string& cell)
{
  return cell.find(',') == std::string::npos ? cell : "\"" + cell + "\"";
}

} // namespace

Numbers numbers(const Case& c, std::size_t number_of_faces, const Measurement& m)
{
  const double faces = double(number_of_faces);
  const auto by_face = [&](double seconds) { return 1e9 * seconds / faces; };
  Numbers result = {{"faces", faces}};
  const auto add = [&](const char* column, bool applies, double value) {
    result.push_back({column, applies ? std::optional<double>(value) : std::nullopt});
  };
  add("regions", !c.is_call, double(m.number_of_regions));
  constexpr const char* stages[number_of_stages] = {"reading", "regions", "graph", "merging",
                                                    "borders"};
  for (std::size_t s = 0; s < number_of_stages; ++s)
    add(stages[s], !c.is_call, by_face(m.seconds_of_stage[s]));
  add("whole", true, by_face(m.seconds));
  add("bytes", true, double(m.peak_bytes) / faces);
  add("floor", true, by_face(m.floor_seconds));
  add("to graph / floor", !c.is_call, m.regions_by_floor);
  add("whole / floor", true, m.whole_by_floor);
  add("/ reference", m.by_reference.has_value(), m.by_reference.value_or(0));
  add("gain of the floor", m.gain_of_floor.has_value(), m.gain_of_floor.value_or(0));
  add("rounds", true, double(m.rounds));
  return result;
}

Table::Table(std::string stem, Facts facts)
  : m_stem(std::move(stem))
  , m_facts(std::move(facts))
{
  write();
}

void Table::add_line(const Case& c, const Numbers& numbers)
{
  m_head = {"mesh", "type", "threads", "what", "reference"};
  Cells line = {name(c.mesh.shape), name(c.mesh.type), std::to_string(c.threads), c.what,
                c.reference};
  for (const auto& [column, value] : numbers) {
    m_head.push_back(column);
    line.push_back(value ? text(*value) : std::string());
  }
  m_lines.push_back(std::move(line));
}

std::string Table::csv(const Facts& facts) const
{
  std::string result;
  for (const auto& [key, value] : facts)
    result += "# " + key + ": " + value + "\n";
  result += joined(m_head, ",", quoted) + "\n";
  for (const Cells& line : m_lines)
    result += joined(line, ",", quoted) + "\n";
  return result;
}

std::string Table::markdown(const Facts& facts) const
{
  std::string result;
  for (const auto& [key, value] : facts)
    result += "- " + key + ": " + value + "\n";
  result += "\n| " + joined(m_head, " | ", as_it_is) + " |\n|";
  for (std::size_t i = 0; i < m_head.size(); ++i)
    result += i < 5 ? "---|" : "---:|";
  result += "\n";
  for (const Cells& line : m_lines)
    result += "| " + joined(line, " | ", as_it_is) + " |\n";
  return result;
}

void Table::write(const Facts& facts_at_end) const
{
  Facts facts = m_facts;
  facts.insert(facts.end(), facts_at_end.begin(), facts_at_end.end());
  write_file(m_stem + ".csv", csv(facts));
  write_file(m_stem + ".md", markdown(facts));
}

} // namespace speed_benchmark
