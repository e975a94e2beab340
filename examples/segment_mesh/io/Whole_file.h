// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WHOLE_FILE_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WHOLE_FILE_H

#include "io/File_buffer.h"
#include "io/Temporary_file.h"

#include <filesystem>
#include <memory>
#include <ostream>
#include <string>

namespace segment_mesh {

/// A file that appears whole or not at all: a temporary one beside it is written, and takes its
/// place when all is on the disk. Until then, and for good if that fails, what was there before
/// stays. Of two that write one file at the same time the last one stays.
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
  std::string m_file;
  std::unique_ptr<Temporary_file> m_temporary;
  File_buffer m_buffer;
  std::ostream m_out;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WHOLE_FILE_H
