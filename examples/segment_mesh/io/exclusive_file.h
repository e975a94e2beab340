// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_EXCLUSIVE_FILE_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_EXCLUSIVE_FILE_H

#include <cstdio>
#include <filesystem>

namespace segment_mesh {

/// Makes a file that is locked until it is closed, and opens it for writing. Only its owner may
/// read it if `target` is a file, which may be private; else those whom the umask lets.
/// \returns null if something of that name is there, which is neither opened nor followed
/// \throws std::system_error
std::FILE* open_exclusively(const std::filesystem::path& path, const std::filesystem::path& target);

/// Gives an open file the permissions of `target`, if that is there and the file system can.
void copy_permissions(const std::filesystem::path& target, std::FILE* file);

/// Waits until all that was written is on the disk, where the file system can tell.
/// \throws std::system_error
void write_to_disk(std::FILE* file);
/// The same for the names in a folder; a folder that may not be read is left alone.
/// \throws std::system_error
void write_folder_to_disk(const std::filesystem::path& folder);

/// Removes a file that `open_exclusively()` made for this user, unless it is locked: whoever made
/// it is gone. Where the file system has no locks nothing is removed.
void remove_if_left_behind(const std::filesystem::path& path);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_EXCLUSIVE_FILE_H
