// SPDX-License-Identifier: GPL-3.0-or-later

// Any words as a command line: jobs whose outputs differ from each other and from the inputs, or
// wrong usage in a line.

#include "command_line/command_line.h"
#include "batch/plan_jobs.h"
#include "read/errors.h"
#include "require.h"

#include <algorithm>
#include <iostream>
#include <set>

using namespace segment_mesh;

namespace {

/// Words end at line breaks, which file names do not need to be told from other bytes.
std::vector<std::string> words_of(const std::string& text)
{
  std::vector<std::string> words = {"segment_mesh"};
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = (std::min)(text.find('\n', start), text.size());
    words.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return words;
}

void check_jobs(const Options& options)
{
  const std::vector<Job> jobs = plan_jobs(options);
  require(jobs.size() == options.inputs.size() + std::size_t(options.is_demo), "an input is a job");
  std::set<std::string> files;
  for (const Job& job : jobs) {
    require(job.outputs.size() == options.outputs.size(), "a job writes all outputs");
    for (const Output& output : job.outputs)
      require(files.insert(output.file).second, "an output is written once: " + output.file);
  }
  for (const Job& job : jobs)
    require(job.is_model || files.count(job.input) == 0, "an input is not replaced: " + job.input);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  std::cout.rdbuf(nullptr); // help and version
  std::string text(reinterpret_cast<const char*>(data), size);
  std::replace(text.begin(), text.end(), '\0', ' '); // no word of a command line has one
  const std::vector<std::string> words = words_of(text);
  std::vector<const char*> argv;
  for (const std::string& word : words)
    argv.push_back(word.c_str());
  try {
    if (const std::optional<Options> options = parse_command_line(int(argv.size()), argv.data()))
      check_jobs(*options);
  } catch (const Usage_error& error) {
    require(std::string(error.what()).find('\n') == std::string::npos, "a message is a line");
  } catch (const Output_error& error) { // a folder that is not there
    require(std::string(error.what()).find('\n') == std::string::npos, "a message is a line");
  }
  return 0;
}
