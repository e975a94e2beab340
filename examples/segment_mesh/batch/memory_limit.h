// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MEMORY_LIMIT_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MEMORY_LIMIT_H

#include <cstdint>
#include <filesystem>

namespace segment_mesh {

/// The bytes that this program can have: the memory of the machine, or less if the limit on address
/// space (`ulimit -v`) or that of a control group (of a container, or of a job of a cluster) is less.
std::uint64_t memory_limit();

/// Gives freed memory back to the machine. glibc keeps it for the thread that had it; another thread
/// would come to hold as much again.
void return_freed_memory();

/// The least limit of the control groups that a process is in; the largest number if there is none.
/// \param groups the file that names them, `/proc/self/cgroup`
/// \param root the folder of all control groups, `/sys/fs/cgroup`; both versions are known
std::uint64_t control_group_memory_limit(const std::filesystem::path& groups,
                                         const std::filesystem::path& root);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MEMORY_LIMIT_H
