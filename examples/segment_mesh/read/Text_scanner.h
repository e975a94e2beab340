// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TEXT_SCANNER_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TEXT_SCANNER_H

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace segment_mesh {

/// Reads words line by line, and fails with the line that it stands on. Lines end with a line feed,
/// a carriage return, or both. A byte order mark before the text is skipped.
class Text_scanner
{
public:
  static constexpr char no_comments = '\0';

  /// Whether a line that ends with a backslash goes on with the next one.
  enum class Continuation { NONE, BACKSLASH };

  /// `file` names the file in messages; `text` must live as long as the scanner. What follows
  /// `comment` on a line is not seen. \throws Input_error for a text in UTF-16
  Text_scanner(const std::string& file, std::string_view text, char comment,
               Continuation continuation = Continuation::NONE);

  /// Goes to the next line that has a word; false, and at the last line, if there is none.
  bool next_line();
  /// The next word of this line; empty if there is none.
  std::string_view word();
  /// The next word of this or a later line; empty at the end of the text.
  std::string_view word_of_any_line();
  /// What is left of this line without blanks around it, a comment, too: a name may have the
  /// character of comments.
  std::string_view rest_of_line();
  bool has_word();
  void skip_line() { m_line = {}; }

  /// The number of this line, from 1.
  std::size_t line_number() const { return m_line_number; }
  /// Where the line after this one starts.
  std::size_t offset_of_next_line() const { return m_next; }
  /// How many bytes are left, from the line after this one.
  std::size_t available() const { return m_text.size() - m_next; }

  /// Names file and line, where what is read ends.
  std::string not_read() const;
  /// \throws Input_error naming file and line
  [[noreturn]] void fail(const std::string& cause) const;

  /// The value of a word.
  /// \throws Input_error if it is not a number, or not a finite one
  double finite_number(std::string_view word) const;
  /// The value of a word that stands for `what`, such as "an index".
  /// \throws Input_error if it is not an integer
  std::int64_t integer(std::string_view word, const char* what) const;

private:
  void take_line();

  std::string m_file;
  std::string_view m_text;
  char m_comment;
  Continuation m_continuation;
  std::string_view m_line; // what is left of this line
  std::string_view m_comment_of_line;
  bool m_goes_on = false; // this line, on the next one
  std::size_t m_next;
  std::size_t m_line_feed; // the first one from m_next on, or the end of the text
  std::size_t m_line_number = 1, m_next_line_number = 1;
};

/// \name The value of a word, as of `Text_scanner`
/// \throws Value_error
/// @{
double finite_number(std::string_view word);
std::int64_t integer(std::string_view word, const char* what);
/// @}

/// The value of a word; 0 if it is not a number, or one too large. For colors and textures, which
/// are no reason to refuse a mesh.
double number_or_zero(std::string_view word);
/// Whether a word is the expected one, which has small letters. Some programs write capitals.
bool is_word(std::string_view word, std::string_view expected);
/// The text without a byte order mark before it.
std::string_view without_byte_order_mark(std::string_view text);
/// \throws Input_error for a text in UTF-16, which is told by its first bytes
void check_encoding(const std::string& file, std::string_view text);
/// A word in quotes, shortened if it is long, with `?` in place of what ASCII cannot print.
std::string in_quotes(std::string_view word);
/// "FILE: not read: 2 bytes".
std::string bytes_not_read(const std::string& file, std::size_t count);
/// "index 4 is out of range: there are 4 points, from 0".
std::string out_of_range(std::int64_t index, std::size_t number, const std::string& what,
                         int first);
/// "1 face", "2 faces".
std::string counted(std::size_t count, const std::string& singular);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TEXT_SCANNER_H
