// SPDX-License-Identifier: GPL-3.0-or-later

#include "Memory_budget.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <random>
#include <thread>
#include <vector>

using namespace segment_mesh;

namespace {

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

TEST(Memory_budget, knows_the_machine)
{
  EXPECT_GT(memory_of_machine(), std::uint64_t(1) << 26);
}

} // namespace
