// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch/run_batch.h"

#include "batch/scores.h"
#include "read/Text_scanner.h"
#include "read/errors.h"
#include "read/read_marks.h"
#include "read/read_mesh.h"
#include "soup/looks_like_machine_part.h"
#include "write/write_segmentation.h"

#include <CGAL/Region_segmentation/Support/exceptions.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <utility>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

namespace segment_mesh {

namespace embedded {
extern const char* const figure_off;
extern const char* const figure_seg;
} // namespace embedded

namespace {

/// A line on stderr, if it is a terminal, that comes after a second of work and goes at the end.
class Progress_line
{
public:
  explicit Progress_line(bool is_wanted)
    : m_is_wanted(is_wanted && is_terminal())
  {}
  Progress_line(const Progress_line&) = delete;
  Progress_line& operator=(const Progress_line&) = delete;
  ~Progress_line() { erase(); }

  /// Draws the line, ten times a second at most. `fraction` of what `words` say is done.
  void show(const std::string& words, double fraction)
  {
    const Clock::time_point now = Clock::now();
    if (!m_is_wanted || now < m_next)
      return;
    m_next = now + std::chrono::milliseconds(100);
    constexpr std::size_t width = 40;
    std::string bar(std::size_t((std::min)((std::max)(fraction, 0.0), 1.0) * width), '#');
    bar.resize(width, '.');
    erase();
    m_drawn = "[" + bar + "] " + words;
    std::cerr << m_drawn << std::flush;
  }

  void erase()
  {
    if (!m_drawn.empty())
      std::cerr << '\r' << std::string(m_drawn.size(), ' ') << '\r' << std::flush;
    m_drawn.clear();
  }

private:
  static bool is_terminal() // stderr
  {
#if defined(__unix__) || defined(__APPLE__)
    return isatty(STDERR_FILENO) != 0;
#else
    return false;
#endif
  }

  using Clock = std::chrono::steady_clock;

  bool m_is_wanted;
  Clock::time_point m_next = Clock::now() + std::chrono::seconds(1);
  std::string m_drawn; ///< what the line holds now
};

/// What is to be said of a job, in whole lines.
struct Job_report
{
  Exit_status status = DONE;
  std::string out, err; ///< for stdout and stderr
};

/// An input with what is known of it.
struct Case
{
  Input_mesh mesh;
  Marks marks;
  std::vector<Truth> truths;
  std::size_t true_number_of_segments = 0; // of the model
};

Case load(const Job& job, const Options& options)
{
  Case result;
  if (job.is_model) {
    result.mesh = parse_mesh(job.input, Mesh_format::OFF, embedded::figure_off);
    result.truths.push_back(
      parse_truth("true parts", embedded::figure_seg, result.mesh.soup.polygons.size()));
    const std::vector<std::int64_t>& parts = result.truths.front().labels;
    result.true_number_of_segments = std::size_t(*std::max_element(parts.begin(), parts.end())) + 1;
  } else {
    result.mesh = read_mesh(job.input, options.input_format);
  }
  result.marks = read_marks(job.side_files, job.input, result.mesh);
  for (const std::string& truth : job.truths)
    result.truths.push_back(read_truth(truth, result.mesh.soup.polygons.size()));
  return result;
}

/// The labels of a file, one for each of its faces, with a remark if they are not 0, 1, ..., and
/// one on faces of no segment.
Segmentation read_labels(const std::string& file, Input_mesh& mesh)
{
  std::vector<std::int64_t> labels = read_truth(file, mesh.soup.polygons.size()).labels;
  Segmentation result = segmentation_from_labels(labels);
  const auto none = std::remove(labels.begin(), labels.end(), std::int64_t(-1));
  if (none != labels.end())
    mesh.remarks.push_back(one_line(file) + ": " +
                           counted(std::size_t(labels.end() - none), "face") +
                           " of no segment: the label is -1");
  labels.erase(none, labels.end());
  const auto [least, greatest] = std::minmax_element(labels.begin(), labels.end());
  if (!labels.empty() && (*least != 0 || *greatest != std::int64_t(result.number_of_segments) - 1))
    mesh.remarks.push_back(one_line(file) + ": labels from " + std::to_string(*least) + " to " +
                           std::to_string(*greatest) + " are numbered from 0 to " +
                           std::to_string(result.number_of_segments - 1));
  return result;
}

/// A segment for each set of the input that has faces, in their order.
Segmentation labels_of_sets(const Face_sets& sets)
{
  Segmentation result = segmentation_from_labels(
    {sets.set_of_face.begin(), sets.set_of_face.end()});
  std::vector<char> is_used(sets.names->size());
  for (std::size_t set : sets.set_of_face)
    is_used[set] = true;
  for (std::size_t set = 0; set < is_used.size(); ++set)
    if (is_used[set])
      result.names.push_back((*sets.names)[set]);
  return result;
}

Segmentation segment(const Job& job, const Case& input, const Segmentation_settings& settings,
                     const Progress_listener& listener)
{
  try {
    return run_segmentation(input.mesh.soup, input.marks, settings, listener);
  } catch (const CGAL::Region_segmentation::Invalid_input& error) {
    throw Input_error(job.input, error.what());
  }
}

/// Why there are `n` segments and not those that were wanted.
std::string reason_for_number(std::size_t n, std::size_t wanted, const Case& input,
                              const Segmentation& segmentation,
                              const Segmentation_settings& settings)
{
  const bool has_marks = !input.marks.constrained_edges.empty() ||
                         !input.marks.seed_of_face.empty();
  if (n > wanted && has_marks)
    return "constraints and seeds give no fewer";
  if (n > wanted)
    return settings.links == Component_links::NONE ? "the mesh has " + counted(n, "connected piece")
                                                   : "its parts are not adjacent";
  if (settings.method == Method::TWO_STEP || settings.method == Method::SMOOTH_FACES)
    return "growing gave " + counted(segmentation.number_of_regions, "region");
  return "the mesh has " + counted(segmentation.segment_of_face.size(), "face");
}

std::string in_seconds(double seconds)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3f s", seconds);
  return text;
}

/// `armadillo.off: 172974 faces, 812 regions, 9 segments, 0.214 s`
std::string describe(const Job& job, const Case& input, const Segmentation& segmentation,
                     const Segmentation_settings& settings)
{
  const std::size_t n = segmentation.number_of_segments;
  const std::size_t wanted = settings.number_of_segments.value_or(n);
  std::string segments = counted(n, "segment");
  if (n != wanted)
    segments += " of " + std::to_string(wanted) + " (" +
                reason_for_number(n, wanted, input, segmentation, settings) + ")";
  else if (segmentation.largest_number)
    segments += " (the most that are chosen: there may be more parts, see -k)";
  const std::string start = one_line(job.input) + ": " +
                            counted(input.mesh.soup.polygons.size(), "face") + ", ";
  if (job.side_files.has_labels())
    return start + segments + "\n";
  return start + counted(segmentation.number_of_regions, "region") + ", " + segments + ", " +
         in_seconds(segmentation.seconds) + "\n";
}

void write_outputs(const Job& job, const Result& result, Verbosity verbosity, Job_report& report)
{
  for (const Output& output : job.outputs) {
    try {
      for (const std::string& remark : write_segmentation(output, result))
        if (verbosity == Verbosity::NORMAL)
          report.err += one_line(output.file) + ": " + remark + "\n";
    } catch (const Output_error& error) {
      report.err += std::string(error.what()) + "\n";
      report.status = FAILED;
    }
  }
}

void run(const Job& job, const Options& options, const Progress_listener& listener,
         Job_report& report)
{
  listener("reading", 0);
  Case input = load(job, options);
  Segmentation_settings settings = options.settings;
  if (job.is_model && !settings.number_of_segments)
    settings.number_of_segments = input.true_number_of_segments;
  const Side_files& side_files = job.side_files;
  const Segmentation segmentation = side_files.labels_from
                                      ? labels_of_sets(sets_of_input(job.input, input.mesh,
                                                                     *side_files.labels_from))
                                    : side_files.has_labels()
                                      ? read_labels(side_files.labels, input.mesh)
                                      : segment(job, input, settings, listener);
  if (options.verbosity == Verbosity::NORMAL)
    for (const std::string& remark : input.mesh.remarks)
      report.err += remark + "\n";

  const bool is_stdout_taken = std::any_of(job.outputs.begin(), job.outputs.end(),
                                           [](const Output& output) { return output.is_stdout(); });
  std::string& lines = is_stdout_taken ? report.err : report.out;
  if (options.verbosity == Verbosity::NORMAL)
    lines += describe(job, input, segmentation, settings);
  if (options.verbosity == Verbosity::NORMAL || !job.truths.empty())
    lines += describe_scores(input.mesh, segmentation.segment_of_face, input.truths);
  listener("writing", 0);
  const Segmentation_details details(input.mesh.soup, settings, segmentation);
  if (options.verbosity == Verbosity::NORMAL && options.inputs.size() == 1 &&
      !side_files.has_labels() && settings.method != Method::SMOOTH_FACES &&
      looks_like_machine_part(input.mesh.soup))
    report.err += one_line(job.input) +
                  ": looks like a machine part, whose faces --method smooth-faces finds\n";
  write_outputs(job,
                {job.input, input.mesh, settings, job.side_files, segmentation, details,
                 options.view, options.coloring},
                options.verbosity, report);
}

/// Reads, segments and writes, whatever happens in it: the others of the batch are to be done, too.
/// The listener hears of the stages, also of reading and writing.
Job_report run_job(const Job& job, const Options& options, const Progress_listener& listener)
{
  Job_report report;
  std::string failure;
  try {
    run(job, options, listener, report);
    return report;
  } catch (const Input_error& error) {
    failure = error.what();
  } catch (const std::bad_alloc&) {
    failure = one_line(job.input) + ": not enough memory";
  } catch (const std::exception& error) {
    failure = one_line(job.input + ": " + error.what());
  }
  report.err += failure + "\n";
  report.status = FAILED;
  return report;
}

} // namespace

Exit_status run_batch(const std::vector<Job>& jobs, const Options& options)
{
  const auto start = std::chrono::steady_clock::now();
  std::size_t number_of_failures = 0;
  bool has_stdout_failed = false;
  Progress_line progress(options.verbosity == Verbosity::NORMAL);
  const std::string of_all = "/" + std::to_string(jobs.size()) + " files";
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const auto listener = [&](const char* stage, double fraction) {
      if (jobs.size() == 1)
        progress.show(stage, fraction);
      else
        progress.show(std::to_string(i) + of_all, double(i) / double(jobs.size()));
      return true;
    };
    const Job_report report = run_job(jobs[i], options, listener);
    progress.erase();
    errno = 0;
    if (std::cout && !(std::cout << report.out << std::flush))
      has_stdout_failed = errno != EPIPE; // a reader that goes early, as `head`, is no failure
    std::cerr << report.err << std::flush;
    number_of_failures += report.status != DONE;
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  if (jobs.size() > 1 && options.verbosity == Verbosity::NORMAL)
    std::cerr << counted(jobs.size(), "input") << ": " << jobs.size() - number_of_failures
              << " done, " << number_of_failures << " failed, " << in_seconds(time.count())
              << std::endl;
  if (!has_stdout_failed)
    return number_of_failures == 0 ? DONE : FAILED;
  std::cerr << "segment_mesh: standard output cannot be written" << std::endl;
  return FAILED;
}

} // namespace segment_mesh
