// SPDX-License-Identifier: GPL-3.0-or-later

#include "allocated_bytes.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

// Off while something is timed. What was allocated before the counting and freed in it counts
// negative, as it should.
std::atomic<bool> is_counting(false);
std::atomic<long long> held(0), most(0);

void count(void* block)
{
  const long long now = held += (long long)(malloc_usable_size(block));
  long long before = most;
  while (before < now && !most.compare_exchange_weak(before, now)) {
  }
}

void* allocate(std::size_t size, std::size_t alignment)
{
  // The size of an aligned block is a multiple of the alignment; there is no block of 0 bytes.
  const std::size_t bytes = (size + (size == 0) + alignment - 1) / alignment * alignment;
  void* block = alignment > alignof(std::max_align_t) ? std::aligned_alloc(alignment, bytes)
                                                      : std::malloc(size + (size == 0));
  if (!block)
    throw std::bad_alloc();
  if (is_counting.load(std::memory_order_relaxed))
    count(block);
  return block;
}

void release(void* block)
{
  if (is_counting.load(std::memory_order_relaxed))
    held -= (long long)(malloc_usable_size(block));
  std::free(block);
}

} // namespace

// The forms for arrays, and those that throw nothing, call these.
void* operator new(std::size_t size)
{
  return allocate(size, 1);
}
void* operator new(std::size_t size, std::align_val_t alignment)
{
  return allocate(size, std::size_t(alignment));
}
void operator delete(void* block) noexcept
{
  release(block);
}
void operator delete(void* block, std::size_t) noexcept
{
  release(block);
}
void operator delete(void* block, std::align_val_t) noexcept
{
  release(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept
{
  release(block);
}

namespace speed_benchmark {

std::size_t peak_of_allocated_bytes(const std::function<void()>& function)
{
  held = 0;
  most = 0;
  is_counting = true;
  function();
  is_counting = false;
  return std::size_t(most);
}

} // namespace speed_benchmark
