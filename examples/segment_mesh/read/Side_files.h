// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SIDE_FILES_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SIDE_FILES_H

#include <string>

namespace segment_mesh {

/// What is read beside a mesh: names of files, empty where there is none.
struct Side_files
{
  std::string labels; ///< if given, nothing is segmented
  std::string constraints, seeds;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SIDE_FILES_H
