// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_MARKS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_MARKS_H

#include "read/read_mesh.h"
#include "segmentation/Marks.h"

#include <vector>

namespace segment_mesh {

/// Reads what a user marked on a mesh. Both files are texts, with comments from `#` to the end of a
/// line, and refer to points and faces of the input's file by their indices from 0 (of an STL file,
/// by those of its different points).
///
/// - `files.constraints`: a line is a sequence of points; each two that follow one another are the
/// ends of an edge.
/// - `files.seeds`: a line is a face and its seed, an integer of at least 0.
///
/// \throws Input_error naming file, line and cause, also for points that no edge joins, and for a
/// face with two seeds
Marks read_marks(const Side_files& files, const Input_mesh& input);

/// The marks as lines on a picture of `input.soup`: constrained edges, and the edges of faces with
/// a seed.
std::vector<Vertex_pair> lines_of_marks(const Marks& marks, const Input_mesh& input);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_READ_MARKS_H
