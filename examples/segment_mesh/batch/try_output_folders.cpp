// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch/try_output_folders.h"

#include "io/Temporary_file.h"
#include "io/Whole_file.h"
#include "io/errors.h"

#include <filesystem>
#include <map>
#include <system_error>

namespace segment_mesh {

namespace fs = std::filesystem;

namespace {

/// Why no file can be made in a folder; empty if one can.
std::string try_folder(const fs::path& folder)
{
  try {
    const Temporary_file file(folder / ".segment_mesh.part");
  } catch (const std::system_error& error) {
    // Another run that tries the same at this moment could make its file.
    if (!Temporary_file::is_locked(error.code()))
      return error.code().message();
  }
  return "";
}

class Folders
{
public:
  /// \throws Output_error
  void check(const std::string& output)
  {
    const fs::path folder = Whole_file::target(output).parent_path();
    const auto [entry, is_new] = m_causes.try_emplace(folder);
    if (is_new)
      entry->second = try_folder(folder);
    if (!entry->second.empty())
      throw Output_error(output, "cannot be written: " + entry->second);
  }

private:
  std::map<fs::path, std::string> m_causes;
};

} // namespace

std::vector<std::vector<std::string>> try_output_folders(const std::vector<Job>& jobs)
{
  Folders folders;
  std::vector<std::vector<std::string>> result(jobs.size());
  for (std::size_t i = 0; i < jobs.size(); ++i)
    for (const std::string& output : jobs[i].outputs) {
      try {
        folders.check(output);
      } catch (const Output_error& error) {
        result[i].push_back(error.what());
      }
    }
  return result;
}

} // namespace segment_mesh
