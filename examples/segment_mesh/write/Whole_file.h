// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WHOLE_FILE_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WHOLE_FILE_H

#include <filesystem>
#include <fstream>
#include <string>

namespace segment_mesh {

/// A file that appears whole or not at all: a temporary one beside it, of a name `.DIGITS.part`
/// that nothing has, is written, and takes its place in the end. Until then, and for good if that
/// fails, what was there before stays. A program that is killed may leave a temporary file.
class Whole_file
{
public:
  /// \throws Output_error if no file can be written there
  explicit Whole_file(const std::string& file);
  Whole_file(const Whole_file&) = delete;
  Whole_file& operator=(const Whole_file&) = delete;
  ~Whole_file();

  std::ostream& stream() { return m_out; }
  /// \throws Output_error if anything was not written
  void commit();

private:
  std::string m_file;
  std::filesystem::path m_target, m_temporary;
  std::ofstream m_out;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WHOLE_FILE_H
