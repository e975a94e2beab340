// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line program: see --help.

#include "batch/available_threads.h"
#include "batch/plan_jobs.h"
#include "batch/run_batch.h"
#include "command_line/command_line.h"
#include "demo/articulated_figure.h"
#include "io/Temporary_file.h"
#include "io/errors.h"
#include "io/standard_streams.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace segment_mesh;

/// The one place that says how many threads there are, for the batch and inside of a mesh.
template <typename Work>
Exit_status run_with_threads(std::size_t wanted, Work work)
{
  const std::size_t number =
    wanted > 0 ? wanted : std::size_t((std::max)(tbb::info::default_concurrency(), 1));
  // One more is for the progress bar.
  const std::size_t available = (std::max)(available_threads(number + 1), std::size_t(2)) - 1;
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, available);
  tbb::task_arena arena{int(available)};
  return arena.execute(work);
}

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

/// The end of what no job has caught, also in a thread of TBB: a line instead of an abort.
void end_with_a_line()
{
  const auto end = [](const char* cause) {
    std::fprintf(stderr, "segment_mesh: %s\n", cause);
    std::_Exit(FAILED);
  };
  try {
    if (const std::exception_ptr exception = std::current_exception())
      std::rethrow_exception(exception);
  } catch (const std::bad_alloc&) {
    end("not enough memory");
  } catch (const std::exception& error) {
    end(error.what());
  } catch (...) {
  }
  end("unknown error");
}

/// For somebody who expected a file.
void hint_at_outputs(const std::vector<Job>& jobs, const Options& options)
{
  if (options.verbosity == Verbosity::QUIET || !options.outputs.empty() || !options.truths.empty())
    return;
  const std::string stem = std::filesystem::path(jobs.front().input).stem().string();
  const std::string name = jobs.size() > 1 ? "'{stem}" : stem, end = jobs.size() > 1 ? "'" : "";
  std::cerr << one_line("Nothing is written. A page to view and rotate the segments: -o " + name + ".html" + end +
                        "; a mesh in their colors: -o " + name + "_segments.ply" + end)
            << std::endl;
}

} // namespace

int main(int argc, char** argv)
{
  std::set_terminate(end_with_a_line);
  occupy_closed_standard_streams();
  ignore_signals_of_writing();
  Temporary_file::remove_all_on_signals();
  try {
    const std::optional<Options> options = parse_command_line(argc, argv);
    if (!options) // help or the like was written
      return std::cout.flush() ? DONE : FAILED;
    const std::vector<Job> jobs = plan_jobs(*options, articulated_figure);
    const Exit_status status = run_with_threads(options->number_of_threads, [&] { return run_batch(jobs, *options); });
    if (status == DONE)
      hint_at_outputs(jobs, *options);
    return status;
  } catch (const Usage_error& error) {
    std::cerr << "segment_mesh: " << error.what() << " (see segment_mesh --help)" << std::endl;
    return WRONG_USAGE;
  }
}
