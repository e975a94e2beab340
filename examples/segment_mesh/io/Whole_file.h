// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WHOLE_FILE_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WHOLE_FILE_H

#include "io/Temporary_file.h"

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

namespace segment_mesh {

/// A file that appears whole or not at all: a temporary one beside it is written, `.NAME.part`, and
/// renamed when all is written. Until then, and for good if that fails, what was there before stays.
class Whole_file
{
public:
  /// \throws Output_error if no file can be written there
  explicit Whole_file(const std::string& file);

  std::ostream& stream() { return m_out; }
  /// \throws Output_error if anything was not written
  void commit();

  /// The file that is to be replaced: behind symbolic links, since renaming onto a link would
  /// replace the link and leave alone what it stands for.
  /// \throws Output_error if it is there and no regular file
  static std::filesystem::path target(const std::string& file);

private:
  [[noreturn]] void fail(const std::string& what, int error_number) const;

  std::string m_file;
  std::filesystem::path m_target;
  std::optional<Temporary_file> m_temporary;
  std::ofstream m_out; ///< closed before the temporary file goes
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WHOLE_FILE_H
