// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TRY_OUTPUT_FOLDERS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TRY_OUTPUT_FOLDERS_H

#include "batch/plan_jobs.h"

#include <string>
#include <vector>

namespace segment_mesh {

/// Tries, before work is spent on them, whether files can be made where the outputs are to be: once
/// in each folder. Removes there what killed runs left of these outputs. For each job what stands in
/// the way, a line for an output: `file: cause`.
std::vector<std::vector<std::string>> try_output_folders(const std::vector<Job>& jobs);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_TRY_OUTPUT_FOLDERS_H
