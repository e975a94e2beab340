// SPDX-License-Identifier: GPL-3.0-or-later

#include "write/Whole_file.h"

#include "read/errors.h"
#include "write/resolve_links.h"

#include <cerrno>
#include <cstdio>
#include <random>
#include <system_error>

namespace segment_mesh {

namespace fs = std::filesystem;

namespace {

std::string reason(int error_number)
{
  return error_number == 0 ? "" : ": " + std::generic_category().message(error_number);
}

/// The file that is to be replaced: behind symbolic links, since renaming onto a link would replace
/// the link.
fs::path target_of(const std::string& file)
{
  const fs::path target = resolve_links(file);
  std::error_code error;
  if (fs::is_symlink(fs::symlink_status(target, error)))
    throw Output_error(file, "is a symbolic link that leads to itself");
  const fs::file_status status = fs::status(target, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw Output_error(file, fs::is_directory(status) ? "is a directory" : "is not a regular file");
  return target;
}

/// An empty file that was not there before.
fs::path make_temporary(const std::string& file, const fs::path& folder)
{
  for (;;) {
    const fs::path path = folder / ("." + std::to_string(std::random_device()()) + ".part");
    if (std::FILE* const made = std::fopen(path.string().c_str(), "wbx")) { // x: not if it is there
      std::fclose(made);
      return path;
    }
    if (errno != EEXIST)
      throw Output_error(file, "cannot be written" + reason(errno));
  }
}

} // namespace

Whole_file::Whole_file(const std::string& file)
  : m_file(file)
  , m_target(target_of(file))
  , m_temporary(make_temporary(file, m_target.parent_path()))
  , m_out(m_temporary, std::ios::binary)
{
  // Before anything is written, since the old file may be private.
  std::error_code ignored;
  if (const fs::file_status old = fs::status(m_target, ignored); fs::is_regular_file(old))
    fs::permissions(m_temporary, old.permissions(), ignored);
  errno = 0;
}

Whole_file::~Whole_file()
{
  std::error_code ignored;
  if (!m_temporary.empty())
    fs::remove(m_temporary, ignored);
}

void Whole_file::commit()
{
  m_out.close();
  if (!m_out)
    throw Output_error(m_file, "cannot be written" + reason(errno));
  std::error_code error;
  fs::rename(m_temporary, m_target, error);
  if (error)
    throw Output_error(m_file, "cannot be written: " + error.message());
  m_temporary.clear();
}

} // namespace segment_mesh
