// SPDX-License-Identifier: GPL-3.0-or-later

#include "Memory_budget.h"

#include <algorithm>
#include <limits>

#if defined(__unix__) || defined(__APPLE__)
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace segment_mesh {

std::uint64_t memory_of_machine()
{
  std::uint64_t bytes = (std::numeric_limits<std::uint64_t>::max)();
#if defined(__unix__) || defined(__APPLE__)
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  if (pages > 0 && size > 0)
    bytes = std::uint64_t(pages) * std::uint64_t(size);
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    bytes = (std::min)(bytes, std::uint64_t(limit.rlim_cur));
#endif
  return bytes;
}

} // namespace segment_mesh
