// SPDX-License-Identifier: GPL-3.0-or-later

#include "Table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <ostream>

namespace princeton_benchmark {

namespace {

std::string print(const char* format, double value)
{
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::vector<std::size_t> widths(const Table& table)
{
  std::vector<std::size_t> result(table.header.size());
  const auto widen = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i)
      result[i] = (std::max)(result[i], row[i].size());
  };
  widen(table.header);
  for (const auto& row : table.rows)
    widen(row);
  return result;
}

void write_html_row(std::ostream& out, const std::vector<std::string>& row, const char* element)
{
  out << "<tr>";
  for (const std::string& cell : row)
    out << "<" << element << ">" << html(cell) << "</" << element << ">";
  out << "</tr>\n";
}

} // namespace

void write_text(std::ostream& out, const Table& table)
{
  const std::vector<std::size_t> width = widths(table);
  const auto write_row = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i)
      out << (i == 0 ? "  " : "   ") << (i == 0 ? std::left : std::right)
          << std::setw(int(width[i])) << row[i];
    out << "\n";
  };
  out << table.title << "\n";
  write_row(table.header);
  for (const auto& row : table.rows)
    write_row(row);
  for (const std::string& note : table.notes)
    out << "  " << note << "\n";
  out << "\n";
}

void write_html(std::ostream& out, const Table& table)
{
  out << "<h2>" << html(table.title) << "</h2>\n<table>\n<thead>";
  write_html_row(out, table.header, "th");
  out << "</thead>\n<tbody>\n";
  for (const auto& row : table.rows)
    write_html_row(out, row, "td");
  out << "</tbody>\n</table>\n";
  for (const std::string& note : table.notes)
    out << "<p class=\"note\">" << html(note) << "</p>\n";
}

std::string score(double value)
{
  return std::isnan(value) ? "-" : print("%.4f", value);
}

std::string published_score(double value)
{
  return print("%.3f", value);
}

std::string seconds(double value)
{
  return print("%.3f", value);
}

std::string counted(std::size_t number, const std::string& thing)
{
  return std::to_string(number) + " " + thing + (number == 1 ? "" : "s");
}

std::string html(const std::string& text)
{
  std::string result;
  for (char c : text)
    switch (c) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
    }
  return result;
}

} // namespace princeton_benchmark
