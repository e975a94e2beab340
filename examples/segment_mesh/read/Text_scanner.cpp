// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/Text_scanner.h"

#include "read/errors.h"
#include "soup/Mesh_properties.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

#ifndef __cpp_lib_to_chars // from_chars() of double is not in every library of C++
#include <fast_float/fast_float.h>
#endif

namespace segment_mesh {

namespace {

#ifdef __cpp_lib_to_chars
using std::from_chars;
#else
using fast_float::from_chars;
#endif

bool is_blank(char c)
{
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/// Without the sign that std::from_chars() does not know.
std::string_view without_plus(std::string_view word)
{
  return word.substr(word.substr(0, 1) == "+" && word.substr(1, 1) != "-" ? 1 : 0);
}

} // namespace

Text_scanner::Text_scanner(const std::string& file, std::string_view text, char comment,
                           Continuation continuation)
  : m_file(file)
  , m_text(text)
  , m_comment(comment)
  , m_continuation(continuation)
  , m_next(text.size() - without_byte_order_mark(text).size())
  , m_line_feed((std::min)(text.find('\n'), text.size()))
{
  check_encoding(file, text);
}

/// \pre there is one
void Text_scanner::take_line()
{
  m_line = m_text.substr(m_next, m_line_feed - m_next);
  m_line = m_line.substr(0, m_line.find('\r'));
  m_next += m_line.size() + 1;
  if (m_next == m_line_feed) // a carriage return before it
    ++m_next;
  m_next = (std::min)(m_next, m_text.size());
  if (m_next > m_line_feed)
    m_line_feed = (std::min)(m_text.find('\n', m_next), m_text.size());
  m_line_number = m_next_line_number++;
  m_comment_of_line = {};
  if (m_comment != no_comments) {
    const std::size_t comment = (std::min)(m_line.find(m_comment), m_line.size());
    m_comment_of_line = m_line.substr(comment);
    m_line = m_line.substr(0, comment);
  }
  m_goes_on = false;
  if (m_continuation == Continuation::BACKSLASH) {
    std::size_t size = m_line.size();
    while (size > 0 && is_blank(m_line[size - 1]))
      --size;
    m_goes_on = size > 0 && m_line[size - 1] == '\\';
    if (m_goes_on)
      m_line = m_line.substr(0, size - 1);
  }
}

bool Text_scanner::next_line()
{
  while (m_goes_on && m_next < m_text.size())
    take_line();
  m_line = {};
  while (m_next < m_text.size()) {
    take_line();
    if (has_word())
      return true;
  }
  return false;
}

std::string_view Text_scanner::rest_of_line()
{
  std::string_view rest = m_line;
  if (!m_comment_of_line.empty()) // it follows in the text
    rest = {m_line.data(), m_line.size() + m_comment_of_line.size()};
  m_line = {};
  while (!rest.empty() && is_blank(rest.front()))
    rest.remove_prefix(1);
  while (!rest.empty() && is_blank(rest.back()))
    rest.remove_suffix(1);
  return rest;
}

bool Text_scanner::has_word()
{
  for (;;) {
    std::size_t start = 0;
    while (start < m_line.size() && is_blank(m_line[start]))
      ++start;
    m_line.remove_prefix(start);
    if (!m_line.empty() || !m_goes_on || m_next == m_text.size())
      return !m_line.empty();
    take_line();
  }
}

std::string_view Text_scanner::word()
{
  if (!has_word())
    return {};
  std::size_t end = 1;
  while (end < m_line.size() && !is_blank(m_line[end]))
    ++end;
  const std::string_view result = m_line.substr(0, end);
  m_line.remove_prefix(end);
  return result;
}

std::string_view Text_scanner::word_of_any_line()
{
  return has_word() || next_line() ? word() : std::string_view();
}

std::string Text_scanner::not_read() const
{
  return one_line(m_file + ":" + std::to_string(m_line_number) + ": not read, nor what follows");
}

void Text_scanner::fail(const std::string& cause) const
{
  throw Input_error(m_file, m_line_number, cause);
}

double finite_number(std::string_view word)
{
  const std::string_view digits = without_plus(word);
  double value = 0;
  const auto [end, error] = from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::invalid_argument || end != digits.data() + digits.size())
    throw Value_error(in_quotes(word) + " is not a number");
  if (error == std::errc::result_out_of_range)
    value = std::strtod(std::string(digits).c_str(), nullptr); // infinite, or near to 0
  if (!std::isfinite(value))
    throw Value_error(in_quotes(word) + " is not a finite number");
  return value;
}

double Text_scanner::finite_number(std::string_view word) const
{
  try {
    return segment_mesh::finite_number(word);
  } catch (const Value_error& error) {
    fail(error.what());
  }
}

std::int64_t integer(std::string_view word, const char* what)
{
  const std::string_view digits = without_plus(word);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size())
    throw Value_error(in_quotes(word) + " is not " + what);
  return value;
}

std::int64_t Text_scanner::integer(std::string_view word, const char* what) const
{
  try {
    return segment_mesh::integer(word, what);
  } catch (const Value_error& error) {
    fail(error.what());
  }
}

double number_or_zero(std::string_view word)
{
  word = without_plus(word);
  double value = 0;
  from_chars(word.data(), word.data() + word.size(), value);
  return usable_value(value);
}

bool is_word(std::string_view word, std::string_view expected)
{
  return std::equal(word.begin(), word.end(), expected.begin(), expected.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

std::string_view without_byte_order_mark(std::string_view text)
{
  constexpr std::string_view mark = "\xef\xbb\xbf";
  return text.substr(text.substr(0, mark.size()) == mark ? mark.size() : 0);
}

void check_encoding(const std::string& file, std::string_view text)
{
  const auto has = [text](std::size_t i, unsigned char byte) {
    return i < text.size() && static_cast<unsigned char>(text[i]) == byte;
  };
  const bool has_mark = (has(0, 0xff) && has(1, 0xfe)) || (has(0, 0xfe) && has(1, 0xff));
  const bool has_zeros = has(0, 0) != has(1, 0) && has(2, 0) != has(3, 0) && has(0, 0) == has(2, 0);
  if (has_mark || has_zeros)
    throw Input_error(file, "is a text in UTF-16: save it as UTF-8");
}

std::string in_quotes(std::string_view word)
{
  constexpr std::size_t longest = 32;
  std::string text(word.substr(0, longest));
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return "'" + text + (word.size() > longest ? "...'" : "'");
}

std::string bytes_not_read(const std::string& file, std::size_t count)
{
  return one_line(file + ": not read: " + counted(count, "byte"));
}

std::string out_of_range(std::int64_t index, std::size_t number, const std::string& what, int first)
{
  return "index " + std::to_string(index) + " is out of range: there are " + counted(number, what) +
         ", from " + std::to_string(first);
}

std::string counted(std::size_t count, const std::string& singular)
{
  if (count == 1)
    return "1 " + singular;
  const bool is_irregular = singular == "vertex";
  return std::to_string(count) + " " + (is_irregular ? "vertices" : singular + "s");
}

} // namespace segment_mesh
