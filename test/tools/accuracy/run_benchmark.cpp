// SPDX-License-Identifier: GPL-3.0-or-later

#include "run_benchmark.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace princeton_benchmark {

namespace {

Model_result run_model(const Model_source& source, const Model_scorer& score)
{
  Model_result result;
  try {
    result = score(source.load());
  } catch (const std::exception& error) {
    result.failure = *error.what() ? error.what() : "failed without a word";
  }
  result.name = source.name;
  result.category = source.category;
  return result;
}

} // namespace

std::vector<Model_result> run_benchmark(const std::vector<Model_source>& sources,
                                        const Model_scorer& score, std::size_t number_of_threads,
                                        const Progress_listener& progress)
{
  std::vector<Model_result> results(sources.size());
  std::atomic<std::size_t> next{0};
  std::size_t done = 0;
  std::mutex telling;
  const auto work = [&] {
    for (std::size_t i = next++; i < sources.size(); i = next++) {
      results[i] = run_model(sources[i], score);
      const std::lock_guard<std::mutex> lock(telling);
      progress(++done);
    }
  };
  std::vector<std::thread> helpers;
  for (std::size_t i = 1; i < (std::min)(number_of_threads, sources.size()); ++i)
    helpers.emplace_back(work);
  work();
  for (std::thread& helper : helpers)
    helper.join();
  return results;
}

} // namespace princeton_benchmark
