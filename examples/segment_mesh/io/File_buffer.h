// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FILE_BUFFER_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FILE_BUFFER_H

#include <cerrno>
#include <cstdio>
#include <streambuf>

namespace segment_mesh {

/// Lets a stream write to an open file of C, which `std::ofstream` cannot take over.
class File_buffer : public std::streambuf
{
public:
  explicit File_buffer(std::FILE* file) : m_file(file) {}

  /// The `errno` of the first failure; 0 if there was none.
  int error() const { return m_error; }

private:
  int_type overflow(int_type c) override
  {
    if (traits_type::eq_int_type(c, traits_type::eof()))
      return traits_type::not_eof(c);
    const char byte = traits_type::to_char_type(c);
    return xsputn(&byte, 1) == 1 ? c : traits_type::eof();
  }

  std::streamsize xsputn(const char* bytes, std::streamsize size) override
  {
    const std::size_t written = std::fwrite(bytes, 1, std::size_t(size), m_file);
    keep_error(written == std::size_t(size));
    return std::streamsize(written);
  }

  int sync() override
  {
    const bool is_done = std::fflush(m_file) == 0;
    keep_error(is_done);
    return is_done ? 0 : -1;
  }

  void keep_error(bool is_done)
  {
    if (!is_done && m_error == 0)
      m_error = errno;
  }

  std::FILE* m_file;
  int m_error = 0;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FILE_BUFFER_H
