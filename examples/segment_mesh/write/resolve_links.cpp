// SPDX-License-Identifier: GPL-3.0-or-later

#include "write/resolve_links.h"

#include <system_error>

namespace segment_mesh {

namespace fs = std::filesystem;

namespace {

/// What `fs::weakly_canonical()` does not do.
fs::path follow_links_to_nothing(fs::path path)
{
  constexpr int most_links = 40; // as on Linux
  std::error_code ignored;
  for (int links = 0; links < most_links && fs::is_symlink(fs::symlink_status(path, ignored)) &&
                      !fs::exists(path, ignored);
       ++links)
    path = path.parent_path() / fs::read_symlink(path, ignored);
  return path;
}

} // namespace

fs::path resolve_links(const std::string& file)
{
  std::error_code error;
  // Of a file that is not there the relative name would stay relative, and have no folder.
  const fs::path path = follow_links_to_nothing(fs::absolute(file, error));
  const fs::path resolved = fs::weakly_canonical(path, error);
  return error ? fs::path(file) : resolved;
}

} // namespace segment_mesh
