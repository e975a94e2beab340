// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PLAN_JOBS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PLAN_JOBS_H

#include "read/read_mesh.h"
#include "segmentation/run_segmentation.h"
#include "view/render_view.h"
#include "view/segment_colors.h"
#include "write/output_format.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace segment_mesh {

enum class Verbosity { NORMAL, QUIET };

/// What the user asks for.
struct Options
{
  std::vector<std::string> inputs;
  std::optional<Mesh_format> input_format; ///< of all inputs; if empty, what their endings name
  bool is_demo = false;                    ///< the model of the program, instead of inputs
  std::vector<Output> outputs;
  std::vector<std::string> truths;
  Side_files side_files;
  Segmentation_settings settings;
  std::size_t number_of_threads = 0;      ///< 0: one for each core
  View_options view;                      ///< of pictures; what is up also of pages
  Coloring coloring = Coloring::SEGMENTS; ///< of pictures and pages
  Verbosity verbosity = Verbosity::NORMAL;
};

/// The name of the model of `--demo`: examples/data/figure.off, whose parts are in figure.seg.
inline constexpr const char* demo_model = "figure";

/// One input and what becomes of it.
struct Job
{
  std::string input; ///< a file, `-` for standard input, or the name of the model
  bool is_model = false;
  std::vector<Output> outputs;
  std::vector<std::string> truths;
  Side_files side_files;
};

/// A job for each input, in order, or one for the model `demo_model`. `{stem}` in the names of
/// outputs, truths and side files becomes the name of the input without folder and endings.
/// \throws Usage_error for two outputs in one file, an output in the place of another file of the
///         run, a batch without `{stem}` or to stdout, standard input without a format or twice,
///         and any other `{name}` of an output
/// \throws Output_error for an output in a folder that is not there
std::vector<Job> plan_jobs(const Options& options);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_PLAN_JOBS_H
