// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FILE_ENDINGS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FILE_ENDINGS_H

#include <string>
#include <vector>

namespace segment_mesh {

/// The last ending of a name, without the dot, in lower case.
std::string ending_of(const std::string& file);

/// As a sentence lists them: ".a, .b or .c".
std::string list_of_endings(const std::vector<std::string>& endings);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_FILE_ENDINGS_H
