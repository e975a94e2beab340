// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LOAD_BYTES_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LOAD_BYTES_H

#include "read/inflate.h"

#include <cstddef>
#include <string>

namespace segment_mesh {

/// The bytes of a regular file, or of standard input for `-`; inflated if they are those of a gzip
/// file. \param expected_size see `inflate()` \throws Input_error also if there are none
std::string load_bytes(const std::string& file, Remarks& remarks,
                       std::size_t expected_size = harmless_size);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LOAD_BYTES_H
