// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch/plan_jobs.h"

#include "read/Mesh_format.h"
#include "read/errors.h"
#include "write/output_format.h"
#include "write/Whole_file.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace segment_mesh {

namespace {

constexpr const char* stem_placeholder = "{stem}";

std::string with_stem(std::string file, const std::string& stem)
{
  const std::string to_replace = stem_placeholder;
  for (std::size_t at = file.find(to_replace); at != std::string::npos;
       at = file.find(to_replace, at + stem.size()))
    file.replace(at, to_replace.size(), stem);
  return file;
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

/// \throws Usage_error for a `{name}` that stands for nothing
void check_names(const Named_file& file)
{
  const std::string& name = file.name;
  for (std::size_t at = name.find('{'); at != std::string::npos; at = name.find('{', at + 1)) {
    const std::size_t end = name.find_first_of("{}", at + 1);
    if (end == std::string::npos || name[end] == '{')
      continue;
    const std::string word = name.substr(at, end + 1 - at);
    const bool can_be_segment = file.option == "-o";
    if (word != stem_placeholder && !(can_be_segment && word == segment_placeholder))
      throw Usage_error(
        file.option + " " + name + ": unknown " + word +
        (can_be_segment ? "; there are {stem} and {segment}" : "; there is {stem} alone"));
  }
}

/// \throws Usage_error for a file that several inputs would share
void check_batch(const Named_file& file)
{
  if (file.option == "-o" && file.name == "-")
    throw Usage_error("-o -: with several inputs outputs are files");
  if (file.name.find(stem_placeholder) == std::string::npos)
    throw Usage_error(file.option + " " + file.name + ": with several inputs it holds " +
                      stem_placeholder);
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

/// The files of a run, to find those that an output would replace.
class File_registry
{
public:
  void add(const std::string& file, const char* what)
  {
    m_files.emplace(resolve_links(file).string(), what);
  }

  /// \throws Usage_error
  void add_output(const Output& output)
  {
    if (output.is_stdout()) {
      if (m_has_stdout)
        throw Usage_error("-o -: would be written twice");
      m_has_stdout = true;
      return;
    }
    if (is_written_directly(output.file))
      return;
    const std::string name = resolve_links(output.file).string();
    if (const std::string library = material_library(output); !library.empty())
      if (const auto found = m_files.find(resolve_links(library).string()); found != m_files.end())
        throw Usage_error("-o " + output.file + ": its .mtl would replace " + found->second);
    if (const std::string* what = find_replaced(name, output))
      throw Usage_error(option_of(output) + " " + output.file + ": would replace " + *what);
    if (is_written_twice(name, output))
      throw Usage_error(option_of(output) + " " + output.file + ": would be written twice");
    (output.is_for_each_segment() ? m_patterns : m_outputs).insert(name);
  }

private:
  const std::string* find_replaced(const std::string& name, const Output& output) const
  {
    auto found = m_files.find(name);
    if (output.is_for_each_segment())
      found = std::find_if(m_files.begin(), m_files.end(),
                           [&](const auto& file) { return is_segment_file(name, file.first); });
    return found == m_files.end() ? nullptr : &found->second;
  }

  bool is_written_twice(const std::string& name, const Output& output) const
  {
    const auto has = [](const std::set<std::string>& names, const auto& is_same) {
      return std::any_of(names.begin(), names.end(), is_same);
    };
    if (m_outputs.count(name) > 0 || m_patterns.count(name) > 0)
      return true;
    if (output.is_for_each_segment())
      return has(m_outputs, [&](const std::string& other) { return is_segment_file(name, other); });
    return has(m_patterns, [&](const std::string& other) { return is_segment_file(other, name); });
  }

  std::map<std::string, std::string> m_files;  ///< with what they are
  std::set<std::string> m_outputs, m_patterns; ///< for one file, and for one for each segment
  bool m_has_stdout = false;
};

void check_outputs(const std::vector<Job>& jobs)
{
  File_registry registry;
  for (const Job& job : jobs) {
    if (!job.is_model && job.input != standard_input)
      registry.add(job.input, "an input");
    if (ending_of(job.input) == "obj")
      registry.add(std::filesystem::path(job.input).replace_extension("mtl").string(),
                   "the materials of an input");
    for (const std::string& truth : job.truths)
      registry.add(truth, "a truth");
    for (const Side_file& file : side_files)
      if (const std::string& name = job.side_files.*file.name; !name.empty())
        registry.add(name, file.what);
  }
  for (const Job& job : jobs)
    for (const Output& output : job.outputs)
      registry.add_output(output);
}

/// \throws Usage_error for an input whose name would make an output one for each segment
Job make_job(const std::string& input, const std::string& stem, const Options& options)
{
  Job job{input, options.is_demo, options.outputs, options.truths, options.side_files};
  for (Output& output : job.outputs) {
    if (output.file.find(stem_placeholder) != std::string::npos &&
        stem.find(segment_placeholder) != std::string::npos)
      throw Usage_error("-o " + output.file + ": {stem} is " + stem +
                        " here, which holds {segment}");
    output.file = with_stem(output.file, stem);
  }
  for (std::string& truth : job.truths)
    truth = with_stem(truth, stem);
  for (const Side_file& file : side_files)
    job.side_files.*file.name = with_stem(job.side_files.*file.name, stem);
  return job;
}

} // namespace

std::vector<Job> plan_jobs(const Options& options, const std::string& demo_model)
{
  check_standard_input(options);
  for (const Named_file& file : files_of(options)) {
    check_names(file);
    if (options.inputs.size() > 1)
      check_batch(file);
  }
  std::vector<Job> jobs;
  for (const std::string& input : options.inputs)
    jobs.push_back(make_job(input, stem_of_input(input), options));
  if (options.is_demo)
    jobs.push_back(make_job(demo_model, demo_model, options));
  check_outputs(jobs);
  return jobs;
}

} // namespace segment_mesh
