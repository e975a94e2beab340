// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LOAD_BYTES_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LOAD_BYTES_H

#include <cstddef>
#include <string>

namespace segment_mesh {

/// A gzip file of a mesh becomes 2 to 30 times as large. What becomes larger than this factor was
/// made to exhaust the memory, and is refused.
constexpr std::size_t largest_inflation = 100;
constexpr std::size_t harmless_size = std::size_t(1) << 20; ///< in bytes

/// The bytes of a regular file, or of standard input for `-`; what a gzip file holds, by zlib.
/// Those after the end of gzip's data are padding. \param expected_size up to which no gzip file is
/// refused \throws Input_error also if there are none
std::string load_bytes(const std::string& file, std::size_t expected_size = harmless_size);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LOAD_BYTES_H
