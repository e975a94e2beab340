// SPDX-License-Identifier: GPL-3.0-or-later

#include "read/errors.h"
#include "write/write_mesh.h"
#include "write/write_segmentation.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <utility>

namespace segment_mesh {

namespace {

namespace fs = std::filesystem;

/// A folder for files that another program reads and writes.
class Temporary_folder
{
public:
  Temporary_folder() { fs::create_directory(m_path); }
  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;
  ~Temporary_folder()
  {
    std::error_code ignored;
    fs::remove_all(m_path, ignored);
  }

  std::string file(const std::string& name) const { return (m_path / name).string(); }

private:
  fs::path m_path = fs::temp_directory_path() /
                    ("segment_mesh." + std::to_string(std::random_device()()));
};

/// For a shell.
std::string quoted(const std::string& file)
{
  return '"' + file + '"';
}

Remarks lines_of(const std::string& file)
{
  std::ifstream text(file);
  Remarks result;
  for (std::string line; std::getline(text, line);)
    result.push_back(line);
  return result;
}

} // namespace

Step_text make_step(const Output& output, const Result& result)
try {
  const Temporary_folder folder;
  const std::string mesh = folder.file("part.off"), step = folder.file("part.step"),
                    said = folder.file("said");
  std::ofstream off(mesh);
  write_off(off, {result.input.soup, result.segmentation.segment_of_face, {}, {}});
  off.close();
  if (!off)
    throw Output_error(output.file, mesh + " cannot be written");
  const std::string command = "mesh_to_step " + quoted(mesh) + ' ' + quoted(step) + " >" +
                              quoted(said) + " 2>&1";
  const int status = std::system(command.c_str());
  Remarks remarks = lines_of(said);
  if (status == 0) {
    std::ifstream text(step, std::ios::binary);
    return {{std::istreambuf_iterator<char>(text), {}}, std::move(remarks)};
  }
  std::string reasons = "no solid";
  for (const std::string& remark : remarks)
    reasons += (&remark == &remarks.front() ? ": " : "; ") + remark;
  constexpr int not_found = 127; // by a shell
  if (status / 256 == not_found)
    reasons += " (an example of this package, which needs OpenCASCADE)";
  throw Output_error(output.file, reasons);
} catch (const fs::filesystem_error& error) {
  throw Output_error(output.file, error.what());
}

} // namespace segment_mesh
