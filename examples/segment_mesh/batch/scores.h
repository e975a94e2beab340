// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SCORES_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SCORES_H

#include "read/read_mesh.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace segment_mesh {

/// A segmentation to be compared with.
struct Truth
{
  std::string name;
  std::vector<std::int64_t> labels; ///< one for each face of the input's file
};

/// Reads a .seg file: a label a line.
/// \throws Input_error unless it has a label for each of `number_of_faces` faces
Truth read_truth(const std::string& file, std::size_t number_of_faces);

/// The same from the bytes of such a file. `name`: of the truth, also in messages
Truth parse_truth(const std::string& name, std::string_view bytes, std::size_t number_of_faces);

/// The measures against each truth, a line each, and a line of means if there are several;
/// each line ends with a newline. They are taken on `make_manifold()` of the input.
/// \param segment_of_face one for each face of the input
std::string describe_scores(const Input_mesh& input,
                            const std::vector<std::size_t>& segment_of_face,
                            const std::vector<Truth>& truths);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SCORES_H
