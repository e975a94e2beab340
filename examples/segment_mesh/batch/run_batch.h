// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_BATCH_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_BATCH_H

#include "batch/plan_jobs.h"

#include <vector>

namespace segment_mesh {

enum Exit_status { DONE = 0, FAILED = 1, WRONG_USAGE = 2 };

/// Runs the jobs one after the other, prints the lines of each when it is done, and sums up
/// several. \returns `FAILED` if one of them failed, else `DONE` \pre SIGPIPE is ignored; else it
/// ends the program
Exit_status run_batch(const std::vector<Job>& jobs, const Options& options);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_BATCH_H
