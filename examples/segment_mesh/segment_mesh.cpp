// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line program: see --help.

#include "Progress_bar.h"
#include "Text_scanner.h"
#include "command_line.h"
#include "errors.h"
#include "plan_jobs.h"
#include "procedural_models.h"
#include "read_mesh.h"
#include "run_segmentation.h"
#include "scores.h"
#include "write_segmentation.h"

#include <CGAL/Region_segmentation/exceptions.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <optional>

namespace {

using namespace segment_mesh;

enum Exit_status { DONE = 0, FAILED = 1, WRONG_USAGE = 2 };

/// An input with what is known of it.
struct Case
{
  Input_mesh mesh;
  std::vector<Truth> truths;
  std::size_t true_number_of_segments = 0; // of a procedural model
};

Case load(const Job& job)
{
  Case result;
  if (job.is_model) {
    Labelled_model model = procedural_models().front().make();
    const std::vector<std::int64_t> labels(model.labels.begin(), model.labels.end());
    result.truths.push_back({"true parts", labels});
    result.true_number_of_segments = model.number_of_parts;
    result.mesh = make_input_mesh(job.input, std::move(model.soup));
  } else {
    result.mesh = read_mesh(job.input);
  }
  for (const std::string& truth : job.truths)
    result.truths.push_back(read_truth(truth, result.mesh.soup.polygons.size()));
  return result;
}

Segmentation segment(const Job& job, const Case& input, const Segmentation_settings& settings,
                     Verbosity verbosity)
{
  std::optional<Progress_bar> bar;
  if (verbosity == Verbosity::NORMAL && is_terminal())
    bar.emplace();
  const auto listener = [&bar](const char* stage, double fraction) {
    if (bar)
      bar->show(stage, fraction);
    return true;
  };
  try {
    return run_segmentation(input.mesh.mesh_soup, settings, listener);
  } catch (const CGAL::Region_segmentation::Invalid_input& error) {
    throw Input_error(job.input, error.what());
  }
}

/// `armadillo.off: 172974 faces, 812 regions, 9 segments, 0.214 s`
std::string describe(const Job& job, const Case& input, const Segmentation& segmentation,
                     const Segmentation_settings& settings)
{
  const std::size_t n = segmentation.number_of_segments;
  const std::size_t wanted = settings.number_of_segments.value_or(n);
  std::string segments = counted(n, "segment");
  if (n != wanted)
    segments +=
      " of " + std::to_string(wanted) +
      (n > wanted ? " (the mesh has " + counted(n, "connected piece") + ")"
       : settings.method == Method::TWO_STEP
         ? " (growing gave " + counted(segmentation.number_of_regions, "region") + ")"
         : " (the mesh has " + counted(segmentation.segment_of_face.size(), "face") + ")");
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.3f s", segmentation.seconds);
  return one_line(job.input) + ": " + counted(input.mesh.soup.polygons.size(), "face") + ", " +
         counted(segmentation.number_of_regions, "region") + ", " + segments + ", " + seconds +
         "\n";
}

Exit_status write_outputs(const Job& job, const Result& result)
{
  Exit_status status = DONE;
  for (const std::string& output : job.outputs) {
    try {
      write_segmentation(output, result);
    } catch (const Output_error& error) {
      std::cerr << error.what() << std::endl;
      status = FAILED;
    }
  }
  return status;
}

Exit_status run(const Job& job, const Options& options)
{
  const Case input = load(job);
  if (options.verbosity == Verbosity::NORMAL)
    for (const std::string& remark : input.mesh.remarks)
      std::cerr << remark << std::endl;

  Segmentation_settings settings = options.settings;
  if (job.is_model && !settings.number_of_segments)
    settings.number_of_segments = input.true_number_of_segments;
  const bool has_details =
    std::any_of(job.outputs.begin(), job.outputs.end(),
                [](const auto& output) { return needs_details(output_format(output)); });
  settings.detail = has_details ? Detail::ALL : Detail::LABELS;
  const Segmentation segmentation = segment(job, input, settings, options.verbosity);

  std::cout << describe(job, input, segmentation, settings)
            << describe_scores(input.mesh, segmentation.segment_of_face, input.truths)
            << std::flush;
  return write_outputs(job, {job.input, input.mesh, settings, segmentation});
}

/// Runs a job whatever happens in it: the others of the batch are to be done too.
Exit_status run_safely(const Job& job, const Options& options)
{
  try {
    return run(job, options);
  } catch (const Input_error& error) {
    std::cerr << error.what() << std::endl;
  } catch (const std::bad_alloc&) {
    std::cerr << one_line(job.input) << ": not enough memory" << std::endl;
  } catch (const std::exception& error) {
    std::cerr << one_line(job.input + ": " + error.what()) << std::endl;
  }
  return FAILED;
}

} // namespace

int main(int argc, char** argv)
{
#ifdef SIGXFSZ
  // A limit on the size of files is to be an error like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
#endif
  try {
    const std::optional<Options> options = parse_command_line(argc, argv);
    if (!options)
      return DONE;
    Exit_status status = DONE;
    for (const Job& job : plan_jobs(*options, procedural_models().front().name))
      status = (std::max)(status, run_safely(job, *options));
    if (std::cout)
      return status;
    std::cerr << "segment_mesh: standard output cannot be written" << std::endl;
    return FAILED;
  } catch (const Usage_error& error) {
    std::cerr << "segment_mesh: " << error.what() << " (see segment_mesh --help)" << std::endl;
    return WRONG_USAGE;
  }
}
