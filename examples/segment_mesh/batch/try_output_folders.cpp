// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch/try_output_folders.h"

#include "io/Temporary_file.h"
#include "io/Whole_file.h"
#include "io/errors.h"

#include <filesystem>
#include <map>
#include <set>
#include <system_error>

namespace segment_mesh {

namespace fs = std::filesystem;

namespace {

/// Why no file can be made in a folder; empty if one can.
std::string try_folder(const fs::path& folder)
{
  try {
    const Temporary_file file(folder / "segment_mesh");
  } catch (const std::system_error& error) {
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
    const fs::path target = Whole_file::target(output);
    const auto [entry, is_new] = m_folders.try_emplace(target.parent_path());
    if (is_new)
      entry->second.obstacle = try_folder(entry->first);
    if (!entry->second.obstacle.empty())
      throw Output_error(output, "cannot be written: " + entry->second.obstacle);
    entry->second.names.insert(target.filename().string());
  }

  void remove_leftovers() const
  {
    for (const auto& [path, folder] : m_folders)
      Temporary_file::remove_leftovers(path, folder.names);
  }

private:
  struct Folder
  {
    std::string obstacle;
    std::set<std::string> names; ///< of the outputs
  };

  std::map<fs::path, Folder> m_folders;
};

} // namespace

std::vector<std::vector<std::string>> try_output_folders(const std::vector<Job>& jobs)
{
  Folders folders;
  std::vector<std::vector<std::string>> result(jobs.size());
  for (std::size_t i = 0; i < jobs.size(); ++i)
    for (const Output& output : jobs[i].outputs) {
      if (output.is_stdout())
        continue;
      try {
        folders.check(output.file);
      } catch (const Output_error& error) {
        result[i].push_back(error.what());
      }
    }
  folders.remove_leftovers();
  return result;
}

} // namespace segment_mesh
