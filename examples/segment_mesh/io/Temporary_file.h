// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TEMPORARY_FILE_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TEMPORARY_FILE_H

#include <cstdio>
#include <filesystem>
#include <set>
#include <string>

namespace segment_mesh {

/// A file beside its target that is there until it takes the target's place or the object goes.
///
/// Its name, `.NAME.RANDOM.part`, cannot be foreseen, and nothing that is there already is opened,
/// written to or followed. It is locked, which tells it from what a killed run left.
class Temporary_file
{
public:
  /// Makes an empty file in the folder of `target`.
  /// \throws std::system_error
  explicit Temporary_file(std::filesystem::path target);
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;
  ~Temporary_file();

  /// For writing.
  std::FILE* file() const { return m_file; }

  /// Puts the file, with all that was written, in the place of its target, whose permissions it
  /// takes over. Both the file and its name are on the disk then.
  /// \throws std::system_error
  void replace_target();

  /// Removes the temporary files that killed runs left in `folder` for targets of these names; `{segment}` in a name stands for
  /// any number.
  static void remove_leftovers(const std::filesystem::path& folder,
                               const std::set<std::string>& names);

  /// From now on the signals that end a program on demand or at a limit (SIGINT, SIGTERM, SIGHUP,
  /// SIGQUIT, SIGXCPU, SIGALRM, SIGUSR1, SIGUSR2), where they are not ignored or handled, remove all
  /// temporary files before they end the program as they always do; where no thread can be started
  /// they only end it. To be called before a thread is started.
  static void remove_all_on_signals();

private:
  std::filesystem::path m_target;
  std::filesystem::path m_path;
  std::FILE* m_file = nullptr;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TEMPORARY_FILE_H
