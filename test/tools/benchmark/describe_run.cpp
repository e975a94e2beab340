// SPDX-License-Identifier: GPL-3.0-or-later

#include "describe_run.h"

#include <CGAL/version.h>

#include <sys/resource.h>
#include <sys/sysinfo.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace speed_benchmark {

namespace {

std::string gibibytes(double bytes)
{
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.2f GiB", bytes / (1u << 30));
  return buffer;
}

std::string processor()
{
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.rfind("model name", 0) == 0)
      return line.substr(line.find(':') + 2);
  return "unknown processor";
}

std::string machine()
{
  struct sysinfo info;
  sysinfo(&info);
  return processor() + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores, " +
         gibibytes(double(info.totalram) * info.mem_unit);
}

std::string load()
{
  double loads[1] = {};
  getloadavg(loads, 1);
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.1f", loads[0]);
  return buffer;
}

} // namespace

Facts describe_run(const std::string& commit, const std::string& note)
{
  Facts facts = {{"machine", machine()},
                 {"load before the run", load()},
                 {"compiler", BENCHMARK_COMPILER},
                 {"flags", BENCHMARK_FLAGS},
                 {"CGAL", CGAL_VERSION_STR}};
  if (!commit.empty())
    facts.push_back({"commit", commit});
  if (!note.empty())
    facts.push_back({"note", note});
  return facts;
}

Facts describe_memory()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return {{"peak resident memory, meshes included", gibibytes(1024.0 * double(usage.ru_maxrss))}};
}

} // namespace speed_benchmark
