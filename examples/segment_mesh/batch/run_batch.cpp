// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch/run_batch.h"

#include "batch/Memory_budget.h"
#include "batch/Progress_bar.h"
#include "batch/Standard_output.h"
#include "batch/memory_limit.h"
#include "batch/try_output_folders.h"
#include "io/Mesh_format.h"
#include "io/errors.h"

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <iostream>
#include <optional>
#include <system_error>

namespace segment_mesh {

namespace {

bool is_ply(const std::string& file, std::optional<Mesh_format> format)
{
  try {
    return (format ? *format : mesh_format(file)) == Mesh_format::PLY;
  } catch (const Input_error&) {
    return false;
  }
}

/// Of a gzip file: 2.1 (binary) to 4.6 times for meshes of \cgal's demos.
constexpr std::uint64_t usual_inflation = 4;

/// Bytes. Measured for 1.5 million triangles: up to 31 times the size of a binary PLY file, 14 times
/// that of the others.
std::uint64_t estimated_memory(const Job& job, std::optional<Mesh_format> format)
{
  if (job.is_model)
    return 0;
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(job.input, error);
  const std::uint64_t inflation = is_compressed(job.input) ? usual_inflation : 1;
  return error ? 0 : (is_ply(job.input, format) ? 36 : 16) * inflation * std::uint64_t(size);
}

/// Bytes. To walk the heaps after each small mesh would not pay.
constexpr std::uint64_t worth_returning = std::uint64_t(1) << 26;

class Batch
{
public:
  Batch(const std::vector<Job>& jobs, const Options& options)
      : m_jobs(jobs), m_options(options), m_obstacles(try_output_folders(jobs)),
        m_budget(memory_limit() / 2)
  {
    if (options.verbosity == Verbosity::NORMAL && is_terminal())
      start_bar();
  }

  /// A job whose outputs cannot be written is not begun; that is told before all others are.
  void tell_obstacles()
  {
    for (const std::vector<std::string>& obstacles : m_obstacles)
      for (const std::string& obstacle : obstacles) {
        std::cerr << obstacle << std::endl;
        m_status = FAILED;
      }
  }

  void run()
  {
    std::size_t next = 0;
    const auto take = [&](tbb::flow_control& control) {
      if (next == m_jobs.size())
        control.stop();
      return next++;
    };
    // What waits for its turn to be printed is a line or two, so there may be any number of it.
    tbb::parallel_pipeline(
      m_jobs.size(),
      tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, take) &
        tbb::make_filter<std::size_t, Job_report>(tbb::filter_mode::parallel,
                                                  [this](std::size_t i) { return work(i); }) &
        tbb::make_filter<Job_report, void>(tbb::filter_mode::serial_in_order,
                                           [this](const Job_report& report) { print(report); }));
  }

  /// The worst of all jobs, after a word if not all that they had to say could be printed.
  Exit_status status() const
  {
    if (!m_output.has_failed())
      return m_status;
    std::cerr << "segment_mesh: standard output cannot be written" << std::endl;
    return FAILED;
  }

private:
  void start_bar()
  {
    try {
      m_bar.emplace();
    } catch (const std::system_error&) { // no thread for it
    }
  }

  Job_report work(std::size_t i)
  {
    if (!m_obstacles[i].empty())
      return {};
    Job_report report;
    const std::uint64_t memory = estimated_memory(m_jobs[i], m_options.input_format);
    const Memory_budget::Share share(m_budget, memory);
    // A thread that waits inside of a mesh must not begin another one.
    tbb::this_task_arena::isolate([&] {
      report = run_job(m_jobs[i], m_options, [this](const char* stage, double fraction) {
        show(stage, fraction);
        return true;
      });
    });
    if (memory > worth_returning)
      return_freed_memory();
    ++m_number_of_done;
    return report;
  }

  /// Of one mesh its stages, of several how many are done.
  void show(const char* stage, double fraction)
  {
    if (!m_bar)
      return;
    const std::size_t done = m_number_of_done, all = m_jobs.size();
    if (all == 1)
      m_bar->show(stage, fraction);
    else
      m_bar->show(std::to_string(done) + "/" + std::to_string(all) + " files",
                  double(done) / double(all));
  }

  void print(const Job_report& report)
  {
    const auto print_lines = [this, &report] {
      m_output.print(report.out);
      std::cerr << report.err << std::flush;
    };
    if (m_bar)
      m_bar->make_room(print_lines);
    else
      print_lines();
    m_status = (std::max)(m_status, report.status);
  }

  const std::vector<Job>& m_jobs;
  const Options& m_options;
  const std::vector<std::vector<std::string>> m_obstacles; ///< for each job
  Memory_budget m_budget;
  std::optional<Progress_bar> m_bar;
  Standard_output m_output;
  std::atomic<std::size_t> m_number_of_done{0};
  Exit_status m_status = DONE;
};

} // namespace

Exit_status run_batch(const std::vector<Job>& jobs, const Options& options)
{
  Batch batch(jobs, options);
  batch.tell_obstacles();
  batch.run();
  return batch.status();
}

} // namespace segment_mesh
