// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_BASE64_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_BASE64_H

#include <string>

namespace segment_mesh {

/// Bytes in the standard alphabet with padding (RFC 4648, section 4).
std::string base64(const std::string& bytes);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_BASE64_H
