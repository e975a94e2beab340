// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PLAN_JOBS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PLAN_JOBS_H

#include "batch/Options.h"

#include <string>
#include <vector>

namespace segment_mesh {

/// One input and what becomes of it.
struct Job
{
  std::string input; ///< a file, `-` for standard input, or the name of a model that the program
                     ///< makes
  bool is_model = false;
  std::vector<Output> outputs;
  std::vector<std::string> truths;
  Side_files side_files;
};

/// A job for each input, in order, or one for the model `demo_model`. `{stem}` in the names of
/// outputs, truths and side files becomes the name of the input without folder and endings. \throws
/// Usage_error for a number of segments that is neither given nor can be chosen, two outputs in one
/// file, an output
///         in the place of another file of the run, a batch without `{stem}` or to stdout, standard
///         input without a format or twice, and any other `{name}`
std::vector<Job> plan_jobs(const Options& options, const std::string& demo_model);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PLAN_JOBS_H
