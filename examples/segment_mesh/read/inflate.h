// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_INFLATE_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_INFLATE_H

#include "read/errors.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace segment_mesh {

/// Whether the bytes start as those of a gzip file do. No text and no format of a mesh starts so.
bool is_gzip(std::string_view bytes);

/// A gzip file of a mesh becomes 2 to 30 times as large. What becomes larger than this factor was
/// made to exhaust the memory, and is refused.
constexpr std::size_t largest_inflation = 100;
constexpr std::size_t harmless_size = std::size_t(1) << 20; ///< in bytes

/// What a gzip file holds, by zlib; several of them in succession hold what they hold together.
/// Zeros after them are padding; of other bytes there is a remark.
/// \param expected_size up to which nothing is refused
/// \throws Input_error if the file is damaged, cut off, or grows too much
std::string inflate(const std::string& file, std::string_view bytes, Remarks& remarks,
                    std::size_t expected_size = harmless_size);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_INFLATE_H
