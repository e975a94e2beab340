// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_BATCH_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_BATCH_H

#include "batch/plan_jobs.h"
#include "batch/run_job.h"

#include <vector>

namespace segment_mesh {

/// Runs the jobs by the threads of this arena, a mesh a thread, and prints their lines in the order
/// of the jobs, each as soon as those before it are printed.
///
/// The memory: as many meshes as threads at most, and no mesh is begun while the estimates for those
/// in work and for itself add up to more than half of `memory_limit()`, unless it is alone.
/// The estimate is 36 times the size of a .ply file and 16 times that of others, 4 times as much if
/// it is compressed, see run_batch.cpp.
/// \returns the worst status
Exit_status run_batch(const std::vector<Job>& jobs, const Options& options);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_BATCH_H
