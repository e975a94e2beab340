// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_MARKS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_MARKS_H

#include "read/read_mesh.h"
#include "segmentation/run_segmentation.h"

#include <vector>

namespace segment_mesh {

/// Reads what a user marked on a mesh, whose file is `file`. Both files are texts, with comments
/// from `#` to the end of a line, and refer to points and faces of the input's file by their
/// indices from 0 (of an STL file, by those of its different points).
///
/// - `files.constraints`: a line is a sequence of points; each two that follow one another are the
/// ends of an edge.
/// - `files.seeds`: a line is a face and its seed, an integer of at least 0.
///
/// `files.constraints_from`: also the edges where faces of different sets of the input meet, where
/// they have equal points.
///
/// \throws Input_error naming file, line and cause, also for points that no edge joins, and for a
/// face with two seeds
Marks read_marks(const Side_files& files, const std::string& file, const Input_mesh& input);

/// The sets of a kind. `file`: the name of that of the input, for messages
/// \throws Input_error if the input has none, naming those that it has
const Face_sets& sets_of_input(const std::string& file, const Input_mesh& input, Set_kind kind);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_MARKS_H
