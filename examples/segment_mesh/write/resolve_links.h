// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RESOLVE_LINKS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RESOLVE_LINKS_H

#include <filesystem>
#include <string>

namespace segment_mesh {

/// The file that is written where `file` is opened: an absolute path without symbolic links, the
/// same for all names of a file, whether it is there or not. The name itself where that cannot be
/// found out; of a link that leads to itself a link.
std::filesystem::path resolve_links(const std::string& file);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RESOLVE_LINKS_H
