// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch/memory_limit.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace segment_mesh {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t no_limit = (std::numeric_limits<std::uint64_t>::max)();

/// What a file of a control group says: a number, or the word `max`.
std::uint64_t read_limit(const fs::path& file)
{
  std::ifstream in(file);
  std::uint64_t bytes = 0;
  return in >> bytes ? bytes : no_limit;
}

/// The least limit of a group and of those that it is in. In a container the names can be those
/// outside of it; then its own group is at the top.
std::uint64_t least_limit(const fs::path& top, const std::string& group, const char* file)
{
  std::uint64_t least = read_limit(top / file);
  fs::path folder = top;
  for (const fs::path& name : fs::path(group).relative_path()) {
    folder /= name;
    least = (std::min)(least, read_limit(folder / file));
  }
  return least;
}

} // namespace

std::uint64_t control_group_memory_limit(const fs::path& groups, const fs::path& root)
{
  std::uint64_t least = no_limit;
  std::ifstream in(groups);
  // NUMBER:CONTROLLERS:GROUP, where version 2 names no controllers.
  for (std::string line; std::getline(in, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos)
      continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",",
                      group = line.substr(second + 1);
    if (controllers == ",,")
      least = (std::min)(least, least_limit(root, group, "memory.max"));
    else if (controllers.find(",memory,") != std::string::npos)
      least = (std::min)(least, least_limit(root / "memory", group, "memory.limit_in_bytes"));
  }
  return least;
}

void return_freed_memory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

std::uint64_t memory_limit()
{
  std::uint64_t bytes = control_group_memory_limit("/proc/self/cgroup", "/sys/fs/cgroup");
#if defined(__unix__) || defined(__APPLE__)
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  if (pages > 0 && size > 0)
    bytes = (std::min)(bytes, std::uint64_t(pages) * std::uint64_t(size));
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    bytes = (std::min)(bytes, std::uint64_t(limit.rlim_cur));
#endif
  return bytes;
}

} // namespace segment_mesh
