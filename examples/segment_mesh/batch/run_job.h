// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_JOB_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_JOB_H

#include "batch/Options.h"
#include "batch/plan_jobs.h"
#include "segmentation/run_segmentation.h"

#include <string>

namespace segment_mesh {

enum Exit_status { DONE = 0, FAILED = 1, WRONG_USAGE = 2 };

/// What is to be said of a job, in whole lines.
struct Job_report
{
  Exit_status status = DONE;
  std::string out, err; ///< for stdout and stderr
};

/// Reads, segments and writes, whatever happens in it: the others of the batch are to be done, too.
/// The listener hears of the stages, also of reading and writing.
Job_report run_job(const Job& job, const Options& options, const Progress_listener& listener);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_JOB_H
