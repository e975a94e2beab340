// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch/available_threads.h"

#include <exception>
#include <future>
#include <thread>
#include <vector>

namespace segment_mesh {

std::size_t available_threads(std::size_t wanted)
{
  std::promise<void> end;
  const std::shared_future<void> ended = end.get_future().share();
  std::vector<std::thread> others;
  others.reserve(wanted);
  try {
    while (others.size() + 1 < wanted)
      others.emplace_back([ended] { ended.wait(); });
  } catch (const std::exception&) { // no thread, or no memory for one
  }
  end.set_value();
  for (std::thread& thread : others)
    thread.join();
  return others.size() + 1;
}

} // namespace segment_mesh
