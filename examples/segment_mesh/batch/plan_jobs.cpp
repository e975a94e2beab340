// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch/plan_jobs.h"

#include "io/Mesh_format.h"
#include "io/errors.h"
#include "io/output_format.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

namespace segment_mesh {

namespace fs = std::filesystem;

namespace {

constexpr const char* placeholder = "{stem}";

std::vector<std::string> with_stem(std::vector<std::string> files, const std::string& stem)
{
  const std::string to_replace = placeholder;
  for (std::string& file : files)
    for (std::size_t at = file.find(to_replace); at != std::string::npos;
         at = file.find(to_replace, at + stem.size()))
      file.replace(at, to_replace.size(), stem);
  return files;
}

/// \throws Usage_error for a `{name}` that stands for nothing
void check_names(const std::vector<std::string>& files, const char* option)
{
  for (const std::string& file : files)
    for (std::size_t at = file.find('{'); at != std::string::npos; at = file.find('{', at + 1)) {
      const std::size_t end = file.find_first_of("{}", at + 1);
      if (end == std::string::npos || file[end] == '{')
        continue;
      const std::string name = file.substr(at, end + 1 - at);
      if (name != placeholder)
        throw Usage_error(std::string(option) + " " + file + ": unknown " + name + "; there is " +
                          placeholder + " alone");
    }
}

void check_placeholders(const std::vector<std::string>& files, const char* option)
{
  for (const std::string& file : files)
    if (file.find(placeholder) == std::string::npos)
      throw Usage_error(std::string(option) + " " + file + ": with several inputs it holds " +
                        placeholder);
}

/// The same for all names of a file.
fs::path canonical_name(const std::string& file)
{
  std::error_code error;
  const fs::path name = fs::weakly_canonical(fs::absolute(file, error), error);
  return error ? fs::path(file) : name;
}

/// \throws Usage_error if the format of standard input is not given, or if it is to be read twice
void check_standard_input(const Options& options)
{
  const auto count = std::count(options.inputs.begin(), options.inputs.end(), standard_input);
  if (count > 0 && !options.input_format)
    throw Usage_error("-: standard input needs --input-format");
  if (count > 1)
    throw Usage_error("-: standard input can be read once");
}

void check_outputs(const std::vector<Job>& jobs)
{
  std::set<fs::path> inputs, truths, outputs;
  for (const Job& job : jobs) {
    if (!job.is_model && job.input != standard_input)
      inputs.insert(canonical_name(job.input));
    for (const std::string& truth : job.truths)
      truths.insert(canonical_name(truth));
  }
  for (const Job& job : jobs)
    for (const std::string& output : job.outputs) {
      const fs::path name = canonical_name(output);
      if (inputs.count(name) > 0)
        throw Usage_error("-o " + output + ": would replace an input");
      if (truths.count(name) > 0)
        throw Usage_error("-o " + output + ": would replace a truth");
      if (!outputs.insert(name).second)
        throw Usage_error("-o " + output + ": would be written twice");
    }
}

} // namespace

std::vector<Job> plan_jobs(const Options& options, const std::string& default_model)
{
  for (const std::string& output : options.outputs)
    output_format(output);
  check_names(options.outputs, "-o");
  check_names(options.truths, "--truth");
  check_standard_input(options);
  const Segmentation_settings& settings = options.settings;
  if (!options.inputs.empty() && !settings.number_of_segments &&
      settings.method == Method::TWO_STEP)
    throw Usage_error("--method two-step needs the number of segments: -k N");
  if (options.inputs.size() > 1) {
    check_placeholders(options.outputs, "-o");
    check_placeholders(options.truths, "--truth");
  }

  std::vector<Job> jobs;
  for (const std::string& input : options.inputs) {
    const std::string stem = stem_of_input(input);
    jobs.push_back(
      {input, false, with_stem(options.outputs, stem), with_stem(options.truths, stem)});
  }
  if (jobs.empty())
    jobs.push_back({default_model, true, with_stem(options.outputs, default_model),
                    with_stem(options.truths, default_model)});
  check_outputs(jobs);
  return jobs;
}

} // namespace segment_mesh
