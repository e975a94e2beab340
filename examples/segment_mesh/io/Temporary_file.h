// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TEMPORARY_FILE_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TEMPORARY_FILE_H

#include <filesystem>

namespace segment_mesh {

/// A file that is there until it is renamed or the object goes.
///
/// It is locked: of two runs that want it at the same time the second is told so. A file of that
/// name without a lock was left behind by a run that was killed, and is taken over. Where the file
/// system knows no locks, nobody may want it twice at a time.
class Temporary_file
{
public:
  /// Makes an empty file.
  /// \throws std::system_error, with `is_locked()` if another object has the file
  explicit Temporary_file(std::filesystem::path path);
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;
  ~Temporary_file();

  const std::filesystem::path& path() const { return m_path; }

  /// Gives the file its final name; it stays then.
  /// \throws std::system_error
  void rename_to(const std::filesystem::path& target);

  static bool is_locked(const std::error_code& error);

  /// From now on SIGINT, SIGTERM and SIGHUP, where they are not ignored, remove all temporary files
  /// before they end the program as they always do. To be called before a thread is started.
  static void remove_all_on_signals();

private:
  std::filesystem::path m_path;
  int m_descriptor = -1; ///< holds the lock
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TEMPORARY_FILE_H
