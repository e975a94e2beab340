// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch/Memory_budget.h"

#include "Temporary_folder.h"
#include "batch/memory_limit.h"
#include "can_limit_memory.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace Memory_budget_test {

using namespace segment_mesh;

TEST(Memory_budget, is_kept_but_by_who_is_alone)
{
  const unsigned seed = std::random_device()();
  constexpr std::uint64_t all = 100;
  Memory_budget budget(all);
  std::atomic<std::uint64_t> taken{0}, number{0};
  std::atomic<std::size_t> together{0}, too_large{0}, wrong{0};
  const auto work = [&](unsigned thread_seed) {
    std::mt19937 random(thread_seed);
    for (int i = 0; i < 100; ++i) {
      const std::uint64_t bytes = 1 + random() % 120;
      const Memory_budget::Share share(budget, bytes);
      const std::uint64_t others = number++;
      wrong += (taken += bytes) > all && others > 0;
      together += others > 0;
      too_large += bytes > all;
      std::this_thread::sleep_for(std::chrono::microseconds(50));
      taken -= bytes;
      --number;
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < 4; ++i)
    threads.emplace_back(work, seed + i);
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(wrong, 0u) << "seed " << seed;
  EXPECT_GT(together, 0u) << "seed " << seed;
  EXPECT_GT(too_large, 0u) << "seed " << seed;
}

/// The memory of the machine, by the kernel's own table.
std::uint64_t machine_memory()
{
  std::ifstream in("/proc/meminfo");
  std::string name, unit;
  std::uint64_t kilobytes = 0;
  in >> name >> kilobytes >> unit;
  return name == "MemTotal:" && unit == "kB" ? 1024 * kilobytes : 0;
}

TEST(Memory_limit, is_that_of_the_machine_or_of_a_group)
{
  const std::uint64_t of_machine = machine_memory();
  if (of_machine == 0)
    GTEST_SKIP() << "no /proc/meminfo";
  const std::uint64_t of_groups = control_group_memory_limit("/proc/self/cgroup", "/sys/fs/cgroup");
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  EXPECT_EQ(memory_limit(), (std::min)({of_machine, of_groups, std::uint64_t(before.rlim_cur)}));
}

TEST(Memory_limit, is_at_most_the_address_space)
{
  if (!can_limit_memory)
    GTEST_SKIP() << "no limit on the address space with the address sanitizer";
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  rlimit lowered = before;
  lowered.rlim_cur = memory_limit() - 4096;
  ASSERT_EQ(setrlimit(RLIMIT_AS, &lowered), 0);
  const std::uint64_t found = memory_limit();
  ASSERT_EQ(setrlimit(RLIMIT_AS, &before), 0);
  EXPECT_EQ(found, lowered.rlim_cur);
}

TEST(Memory_limit, is_the_least_of_the_control_groups)
{
  const Temporary_folder folder;
  std::filesystem::create_directories(folder.path("a/b"));
  std::filesystem::create_directories(folder.path("memory/c"));
  const auto limit = [&folder](const std::string& groups) {
    return control_group_memory_limit(folder.write("groups", groups), folder.path(""));
  };
  const std::uint64_t none = std::uint64_t(-1);
  EXPECT_EQ(control_group_memory_limit(folder.path("no file"), folder.path("")), none);
  EXPECT_EQ(limit("0::/a/b\n"), none);
  folder.write("a/b/memory.max", "max\n");
  EXPECT_EQ(limit("0::/a/b\n"), none);
  folder.write("a/memory.max", "5000\n");
  EXPECT_EQ(limit("0::/a/b\n"), 5000u);
  EXPECT_EQ(limit("0::/\n"), none);
  folder.write("memory.max", "4000\n");
  EXPECT_EQ(limit("0::/unknown/here\n"), 4000u);

  folder.write("memory/c/memory.limit_in_bytes", "3000\n");
  EXPECT_EQ(limit("5:cpu,cpuacct:/a\n4:memory:/c\n"), 3000u);
  EXPECT_EQ(limit("5:cpu,cpuacct:/a\n4:freezer,memory:/c/d\n0::/a/b\n"), 3000u);
  EXPECT_EQ(limit("4:memory\nnonsense\n"), none);
}

} // namespace Memory_budget_test
