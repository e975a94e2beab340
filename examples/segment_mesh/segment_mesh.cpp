// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line program: see --help.

#include "batch/plan_jobs.h"
#include "batch/run_batch.h"
#include "command_line/command_line.h"
#include "read/errors.h"
#include "write/Whole_file.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace segment_mesh;

/// A full disk, and a reader of stdout that is gone, are to be errors where they are met.
void ignore_signals_of_writing()
{
#ifdef SIGXFSZ
  std::signal(SIGXFSZ, SIG_IGN);
#endif
#ifdef SIGPIPE
  std::signal(SIGPIPE, SIG_IGN);
#endif
}

/// For somebody who expected a file.
void hint_at_outputs(const std::vector<Job>& jobs, const Options& options)
{
  if (options.verbosity == Verbosity::QUIET || !options.outputs.empty() || !options.truths.empty())
    return;
  const std::string stem = std::filesystem::path(jobs.front().input).stem().string();
  const std::string name = jobs.size() > 1 ? "'{stem}" : stem, end = jobs.size() > 1 ? "'" : "";
  std::cerr << one_line("Nothing is written. A page to view and rotate the segments: -o " + name +
                        ".html" + end + "; a mesh in their colors: -o " + name + "_segments.ply" +
                        end)
            << std::endl;
}

} // namespace

int main(int argc, char** argv)
{
  occupy_closed_standard_streams();
  ignore_signals_of_writing();
  try {
    const std::optional<Options> options = parse_command_line(argc, argv);
    if (!options) // help or the like was written
      return std::cout.flush() ? DONE : FAILED;
    const std::vector<Job> jobs = plan_jobs(*options);
#ifdef CGAL_LINKED_WITH_TBB
    std::optional<tbb::global_control> limit;
    if (options->number_of_threads > 0)
      limit.emplace(tbb::global_control::max_allowed_parallelism, options->number_of_threads);
#endif
    const Exit_status status = run_batch(jobs, *options);
    if (status == DONE)
      hint_at_outputs(jobs, *options);
    return status;
  } catch (const Usage_error& error) {
    std::cerr << "segment_mesh: " << error.what() << " (see segment_mesh --help)" << std::endl;
    return WRONG_USAGE;
  } catch (const std::exception& error) { // what no job has caught
    std::cerr << "segment_mesh: " << one_line(error.what()) << std::endl;
    return FAILED;
  }
}
