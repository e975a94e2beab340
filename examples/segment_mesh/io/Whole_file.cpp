// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Whole_file.h"

#include "io/errors.h"

#include <cerrno>
#include <system_error>

namespace segment_mesh {

namespace fs = std::filesystem;

Whole_file::Whole_file(const std::string& file) : m_file(file), m_target(target(file))
{
  try {
    m_temporary.emplace(m_target.parent_path() / ("." + m_target.filename().string() + ".part"));
  } catch (const std::system_error& error) {
    if (Temporary_file::is_locked(error.code()))
      throw Output_error(file, "is being written by another run");
    fail("cannot be opened", error.code().value());
  }
  errno = 0;
  m_out.open(m_temporary->path(), std::ios::binary | std::ios::trunc);
  if (!m_out)
    fail("cannot be opened", errno);
  errno = 0; // what commit() finds there is of a write
}

void Whole_file::commit()
{
  m_out.close();
  if (!m_out)
    fail("cannot be written", errno);
  try {
    m_temporary->rename_to(m_target);
  } catch (const std::system_error& error) {
    fail("cannot be written", error.code().value());
  }
  m_temporary.reset();
}

fs::path Whole_file::target(const std::string& file)
{
  std::error_code error;
  fs::path result = fs::weakly_canonical(file, error);
  if (error)
    result = file;
  const fs::file_status status = fs::status(result, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw Output_error(file, fs::is_directory(status) ? "is a directory" : "is not a regular file");
  return result;
}

void Whole_file::fail(const std::string& what, int error_number) const
{
  const std::string reason =
    error_number == 0 ? "" : ": " + std::generic_category().message(error_number);
  throw Output_error(m_file, what + reason);
}

} // namespace segment_mesh
