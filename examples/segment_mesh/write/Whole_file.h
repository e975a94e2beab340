// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WHOLE_FILE_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WHOLE_FILE_H

#include <filesystem>
#include <fstream>
#include <string>

namespace segment_mesh {

/// The name of stdout as an output.
constexpr const char* standard_output = "-";

/// An output. A file appears whole or not at all: a temporary one beside it, of a random name
/// `.DIGITS.part`, is written, and takes its place in the end. Until then, and for
/// good if that fails, what was there before stays. A program that is killed may leave a temporary
/// file. What `is_written_directly()` alone can be left half written.
class Whole_file
{
public:
  /// Waits for the reader of a named pipe. \throws Output_error if nothing can be written there
  explicit Whole_file(const std::string& file);
  Whole_file(const Whole_file&) = delete;
  Whole_file& operator=(const Whole_file&) = delete;
  ~Whole_file();

  std::ostream& stream();
  /// That the reader of stdout or of a pipe goes early, as `head` does, is no failure.
  /// \throws Output_error if anything was not written
  void commit();

private:
  std::string m_file;
  std::filesystem::path m_target, m_temporary; ///< empty if it is written directly
  std::ofstream m_out;
};

/// Whether an output is stdout, a device, a named pipe or an open descriptor (`/dev/fd/3`).
bool is_written_directly(const std::string& file);

/// The file that is written where `file` is opened: an absolute path without symbolic links, the
/// same for all names of a file. A link that leads to nothing stays, and will be replaced; so does
/// the name where the file cannot be found out.
std::string resolve_links(const std::string& file);

/// Occupies the descriptors of those of stdin, stdout and stderr that are closed, so that no file
/// gets them, into which messages would be written then. Reading from them, or writing to them,
/// remains an error. To be called before a file is opened.
void occupy_closed_standard_streams();

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_WHOLE_FILE_H
