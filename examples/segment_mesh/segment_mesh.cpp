// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line program: see --help.

#include "batch/plan_jobs.h"
#include "batch/run_batch.h"
#include "command_line/command_line.h"
#include "demo/articulated_figure.h"
#include "io/Temporary_file.h"
#include "io/errors.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <optional>

namespace {

using namespace segment_mesh;

/// The one place that says how many threads there are, for the batch and inside of a mesh.
template <typename Work>
Exit_status run_with_threads(std::size_t wanted, Work work)
{
  const std::size_t number =
    wanted > 0 ? wanted : std::size_t((std::max)(tbb::info::default_concurrency(), 1));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, number);
  tbb::task_arena arena{int(number)};
  return arena.execute(work);
}

} // namespace

int main(int argc, char** argv)
{
#ifdef SIGXFSZ
  // A limit on the size of files is to be an error like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
#endif
  Temporary_file::remove_all_on_signals();
  try {
    const std::optional<Options> options = parse_command_line(argc, argv);
    if (!options)
      return DONE;
    const std::vector<Job> jobs = plan_jobs(*options, articulated_figure);
    const Exit_status status =
      run_with_threads(options->number_of_threads, [&] { return run_batch(jobs, *options); });
    if (std::cout)
      return status;
    std::cerr << "segment_mesh: standard output cannot be written" << std::endl;
    return FAILED;
  } catch (const Usage_error& error) {
    std::cerr << "segment_mesh: " << error.what() << " (see segment_mesh --help)" << std::endl;
    return WRONG_USAGE;
  }
}
