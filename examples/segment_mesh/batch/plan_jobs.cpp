// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch/plan_jobs.h"

#include "read/errors.h"
#include "read/read_mesh.h"
#include "write/Whole_file.h"
#include "write/output_format.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>

namespace segment_mesh {

namespace {

constexpr const char* stem_placeholder = "{stem}";

std::string with_stem(const std::string& file, const std::string& stem)
{
  return boost::replace_all_copy(file, stem_placeholder, stem);
}

/// A side file, its option, and what it is in messages.
struct Side_file
{
  std::string Side_files::*name;
  const char *option, *what;
};

constexpr Side_file side_files[] = {{&Side_files::labels, "--labels", "the labels"},
                                    {&Side_files::constraints, "--constraints", "the constraints"},
                                    {&Side_files::seeds, "--seeds", "the seeds"}};

/// A name of a file on the command line, and the option that it belongs to.
struct Named_file
{
  std::string option, name;
};

std::string option_of(const Output& output)
{
  return output.content == Output_content::BORDERS ? "--borders" : "-o";
}

std::vector<Named_file> files_of(const Options& options)
{
  std::vector<Named_file> files;
  for (const Output& output : options.outputs)
    files.push_back({option_of(output), output.file});
  for (const std::string& truth : options.truths)
    files.push_back({"--truth", truth});
  for (const Side_file& file : side_files)
    if (const std::string& name = options.side_files.*file.name; !name.empty())
      files.push_back({file.option, name});
  return files;
}

/// \throws Usage_error for a `{name}` of an output that stands for nothing
void check_names(const Output& output)
{
  const std::string rest = with_segment(with_stem(output.file, ""), "");
  const std::size_t begin = rest.find('{'), end = rest.find('}', begin);
  if (end != std::string::npos)
    throw Usage_error(option_of(output) + " " + output.file +
                      ": there are {stem} and {segment}, not " +
                      rest.substr(begin, end + 1 - begin));
}

/// \throws Usage_error for a file that several inputs would share
void check_batch(const Named_file& file)
{
  if (file.option == "-o" && file.name == "-")
    throw Usage_error("-o -: with several inputs outputs are files");
  if (file.name.find(stem_placeholder) == std::string::npos)
    throw Usage_error(file.option + " " + file.name + ": with several inputs it holds " +
                      stem_placeholder +
                      (file.option == "-o" ? "; several outputs are -o FILE -o FILE" : ""));
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

/// The files of a run by their names without links, and what they are.
using Run_files = std::map<std::string, std::string>;

constexpr const char* output_of_run = "an output";

Run_files files_to_read(const std::vector<Job>& jobs)
{
  Run_files files;
  for (const Job& job : jobs) {
    if (!job.is_model && job.input != standard_input)
      files.emplace(resolve_links(job.input), "an input");
    for (const std::string& truth : job.truths)
      files.emplace(resolve_links(truth), "a truth");
    for (const Side_file& file : side_files)
      if (const std::string& name = job.side_files.*file.name; !name.empty())
        files.emplace(resolve_links(name), file.what);
  }
  return files;
}

/// Adds an output to the files of a run. \throws Usage_error if one of them would be replaced
void add_output(const Output& output, Run_files& files)
{
  if (!output.is_stdout() && is_written_directly(output.file))
    return;
  const auto [file, is_new] = files.emplace(
    output.is_stdout() ? output.file : resolve_links(output.file), output_of_run);
  if (!is_new)
    throw Usage_error(
      option_of(output) + " " + output.file + ": " +
      (file->second == output_of_run ? "would be written twice" : "would replace " + file->second));
}

/// \throws Output_error if an output would be in a folder that is not there
void check_folders(const std::vector<Job>& jobs)
{
  std::error_code ignored;
  for (const Job& job : jobs)
    for (const Output& output : job.outputs)
      if (!is_written_directly(output.file) &&
          !std::filesystem::is_directory(
            std::filesystem::path(resolve_links(output.file)).parent_path(), ignored))
        throw Output_error(output.file, "there is no such folder");
}

Job make_job(const std::string& input, const std::string& stem, const Options& options)
{
  Job job{input, options.is_demo, options.outputs, options.truths, options.side_files};
  for (Output& output : job.outputs)
    output.file = with_stem(output.file, stem);
  for (std::string& truth : job.truths)
    truth = with_stem(truth, stem);
  for (const Side_file& file : side_files)
    job.side_files.*file.name = with_stem(job.side_files.*file.name, stem);
  return job;
}

} // namespace

std::vector<Job> plan_jobs(const Options& options)
{
  check_standard_input(options);
  for (const Output& output : options.outputs)
    check_names(output);
  if (options.inputs.size() > 1)
    for (const Named_file& file : files_of(options))
      check_batch(file);
  std::vector<Job> jobs;
  for (const std::string& input : options.inputs)
    jobs.push_back(make_job(input, stem_of_input(input), options));
  if (options.is_demo)
    jobs.push_back(make_job(demo_model, demo_model, options));
  Run_files files = files_to_read(jobs);
  for (const Job& job : jobs)
    for (const Output& output : job.outputs)
      add_output(output, files);
  check_folders(jobs);
  return jobs;
}

} // namespace segment_mesh
