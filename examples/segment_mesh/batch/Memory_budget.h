// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MEMORY_BUDGET_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MEMORY_BUDGET_H

#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace segment_mesh {

/// Bytes that threads take before they work, and give back after. Who finds too few left waits, but
/// never when nobody else has any: then more than all may be taken.
class Memory_budget
{
public:
  explicit Memory_budget(std::uint64_t bytes) : m_bytes(bytes) {}

  /// Bytes for as long as it lives. Waits until they are there.
  class Share
  {
  public:
    Share(Memory_budget& budget, std::uint64_t bytes) : m_budget(budget), m_bytes(bytes)
    {
      std::unique_lock<std::mutex> lock(m_budget.m_mutex);
      m_budget.m_given_back.wait(lock, [this] { return m_budget.can_give(m_bytes); });
      m_budget.m_taken += m_bytes;
      ++m_budget.m_number_of_shares;
    }
    Share(const Share&) = delete;
    Share& operator=(const Share&) = delete;
    ~Share()
    {
      {
        const std::lock_guard<std::mutex> lock(m_budget.m_mutex);
        m_budget.m_taken -= m_bytes;
        --m_budget.m_number_of_shares;
      }
      m_budget.m_given_back.notify_all();
    }

  private:
    Memory_budget& m_budget;
    std::uint64_t m_bytes;
  };

private:
  bool can_give(std::uint64_t bytes) const
  {
    return m_number_of_shares == 0 || (m_taken <= m_bytes && bytes <= m_bytes - m_taken);
  }

  const std::uint64_t m_bytes;
  std::mutex m_mutex;
  std::condition_variable m_given_back;
  std::uint64_t m_taken = 0;
  std::uint64_t m_number_of_shares = 0;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MEMORY_BUDGET_H
