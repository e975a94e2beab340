// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Whole_file.h"

#include "io/errors.h"
#include "io/resolve_links.h"

#include <system_error>

namespace segment_mesh {

namespace fs = std::filesystem;

namespace {

std::string reason(int error_number)
{
  return error_number == 0 ? "" : ": " + std::generic_category().message(error_number);
}

std::unique_ptr<Temporary_file> make_temporary(const std::string& file)
{
  try {
    return std::make_unique<Temporary_file>(Whole_file::target(file));
  } catch (const std::system_error& error) {
    throw Output_error(file, "cannot be opened" + reason(error.code().value()));
  }
}

} // namespace

Whole_file::Whole_file(const std::string& file)
    : m_file(file), m_temporary(make_temporary(file)), m_buffer(m_temporary->file()),
      m_out(&m_buffer)
{
}

void Whole_file::commit()
{
  m_out.flush();
  if (!m_out)
    throw Output_error(m_file, "cannot be written" + reason(m_buffer.error()));
  try {
    m_temporary->replace_target();
  } catch (const std::system_error& error) {
    throw Output_error(m_file, "cannot be written" + reason(error.code().value()));
  }
  m_temporary.reset();
}

fs::path Whole_file::target(const std::string& file)
{
  const fs::path result = resolve_links(file);
  std::error_code error;
  if (fs::is_symlink(fs::symlink_status(result, error)))
    throw Output_error(file, "is a symbolic link that leads to itself");
  const fs::file_status status = fs::status(result, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw Output_error(file, fs::is_directory(status) ? "is a directory" : "is not a regular file");
  return result;
}

} // namespace segment_mesh
