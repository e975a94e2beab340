// SPDX-License-Identifier: GPL-3.0-or-later

#include "write/Whole_file.h"

#include "read/errors.h"

#include <cerrno>
#include <initializer_list>
#include <iostream>
#include <random>
#include <system_error>

#if defined(__unix__) || defined(__APPLE__)
#include <fcntl.h>
#include <unistd.h>
#endif

namespace segment_mesh {

namespace fs = std::filesystem;

namespace {

std::string reason(int error_number)
{
  return error_number == 0 ? "" : ": " + std::generic_category().message(error_number);
}

} // namespace

Whole_file::Whole_file(const std::string& file)
  : m_file(file)
{
  errno = 0;
  if (file == standard_output)
    return;
  if (is_written_directly(file)) {
    m_out.open(file, std::ios::binary | std::ios::app); // behind what a descriptor has written
    if (!m_out)
      throw Output_error(file, "cannot be written" + reason(errno));
    return;
  }
  // Behind symbolic links, since renaming onto a link would replace the link.
  m_target = resolve_links(file);
  std::error_code ignored;
  if (fs::is_directory(m_target, ignored))
    throw Output_error(file, "is a directory");
  m_temporary = m_target.parent_path() / ("." + std::to_string(std::random_device()()) + ".part");
  m_out.open(m_temporary, std::ios::binary);
  if (!m_out)
    throw Output_error(file, "cannot be written" + reason(errno));
  // Before anything is written, since the old file may be private.
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

std::ostream& Whole_file::stream()
{
  return m_file == standard_output ? std::cout : m_out;
}

void Whole_file::commit()
{
  if (m_out.is_open())
    m_out.close();
  else
    std::cout.flush();
  if (!stream() && !(m_temporary.empty() && errno == EPIPE))
    throw Output_error(m_file == standard_output ? "standard output" : m_file,
                       "cannot be written" + reason(errno));
  if (m_temporary.empty())
    return;
  std::error_code error;
  fs::rename(m_temporary, m_target, error);
  if (error)
    throw Output_error(m_file, "cannot be written: " + error.message());
  m_temporary.clear();
}

bool is_written_directly(const std::string& file)
{
  std::error_code ignored;
  const fs::path folder = fs::absolute(file, ignored).lexically_normal().parent_path();
  const fs::file_status status = fs::status(file, ignored);
  return file == standard_output || file == "/dev/stderr" || folder == "/dev/fd" ||
         folder == "/proc/self/fd" ||
         (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status));
}

std::string resolve_links(const std::string& file)
{
  std::error_code error;
  // Of a file that is not there the relative name would stay relative, and have no folder.
  const fs::path resolved = fs::weakly_canonical(fs::absolute(file, error), error);
  return error ? file : resolved.string();
}

void occupy_closed_standard_streams()
{
#if defined(__unix__) || defined(__APPLE__)
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(descriptor, F_GETFD) < 0) // an opened file gets the lowest free descriptor: this one
      static_cast<void>(open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY));
#endif
}

} // namespace segment_mesh
