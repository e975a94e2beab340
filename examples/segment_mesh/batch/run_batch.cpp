// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch/run_batch.h"

#include "batch/Progress_bar.h"
#include "batch/Standard_output.h"

#include <algorithm>
#include <iostream>
#include <optional>
#include <string>
#include <system_error>

namespace segment_mesh {

namespace {

/// The progress bar, if there is to be one.
class Display
{
public:
  Display(Verbosity verbosity, std::size_t number_of_jobs)
    : m_number_of_jobs(number_of_jobs)
  {
    try {
      if (verbosity == Verbosity::NORMAL && is_terminal())
        m_bar.emplace();
    } catch (const std::system_error&) { // no thread for it
    }
  }

  /// Of one mesh its stages, of several how many are done.
  void show(std::size_t job, const char* stage, double fraction)
  {
    if (!m_bar)
      return;
    if (m_number_of_jobs == 1)
      m_bar->show(stage, fraction);
    else
      m_bar->show(std::to_string(job) + "/" + std::to_string(m_number_of_jobs) + " files",
                  double(job) / double(m_number_of_jobs));
  }

  void print(const Job_report& report)
  {
    const auto print_lines = [&] {
      m_output.print(report.out);
      std::cerr << report.err << std::flush;
    };
    if (m_bar)
      m_bar->make_room(print_lines);
    else
      print_lines();
  }

  bool has_failed() const { return m_output.has_failed(); }

private:
  std::size_t m_number_of_jobs;
  std::optional<Progress_bar> m_bar;
  Standard_output m_output;
};

} // namespace

Exit_status run_batch(const std::vector<Job>& jobs, const Options& options)
{
  Exit_status status = DONE;
  bool has_failed = false;
  {
    Display display(options.verbosity, jobs.size());
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      const Job_report report = run_job(jobs[i], options, [&](const char* stage, double fraction) {
        display.show(i, stage, fraction);
        return true;
      });
      display.print(report);
      status = (std::max)(status, report.status);
    }
    has_failed = display.has_failed();
  } // the bar is gone
  if (!has_failed)
    return status;
  std::cerr << "segment_mesh: standard output cannot be written" << std::endl;
  return FAILED;
}

} // namespace segment_mesh
