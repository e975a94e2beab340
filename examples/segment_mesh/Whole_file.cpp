// SPDX-License-Identifier: GPL-3.0-or-later

#include "Whole_file.h"

#include "errors.h"

#include <cerrno>
#include <random>
#include <system_error>

namespace segment_mesh {

namespace fs = std::filesystem;

Whole_file::Whole_file(const std::string& file) : m_file(file)
{
  std::error_code error;
  // Renaming onto a symbolic link would replace the link and leave alone what it stands for.
  m_target = fs::weakly_canonical(file, error);
  if (error)
    m_target = file;
  const fs::file_status status = fs::status(m_target, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw Output_error(file, fs::is_directory(status) ? "is a directory" : "is not a regular file");

  m_temporary =
    m_target.parent_path() / (".segment_mesh-" + std::to_string(std::random_device()()) + ".part");
  errno = 0;
  m_out.open(m_temporary, std::ios::binary | std::ios::trunc);
  if (!m_out)
    fail("cannot be opened", errno);
  errno = 0; // what commit() finds there is of a write
}

Whole_file::~Whole_file()
{
  if (m_temporary.empty())
    return;
  m_out.close();
  std::error_code ignored;
  fs::remove(m_temporary, ignored);
}

void Whole_file::commit()
{
  m_out.close();
  if (!m_out)
    fail("cannot be written", errno);
  std::error_code error;
  fs::rename(m_temporary, m_target, error);
  if (error)
    throw Output_error(m_file, "cannot be written: " + error.message());
  m_temporary.clear();
}

void Whole_file::fail(const std::string& what, int error_number) const
{
  const std::string reason =
    error_number == 0 ? "" : ": " + std::generic_category().message(error_number);
  throw Output_error(m_file, what + reason);
}

} // namespace segment_mesh
