// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_DIGEST_H
#define CGAL_REGION_SEGMENTATION_TEST_DIGEST_H

#include <cstdint>

namespace test {

/// FNV-1a of values as 64 bits, the lowest byte first: the same on every machine.
class Digest
{
public:
  void add(std::uint64_t value)
  {
    for (int i = 0; i < 8; ++i, value >>= 8)
      m_state = (m_state ^ (value & 255)) * 0x100000001b3u;
  }
  std::uint64_t value() const { return m_state; }

private:
  std::uint64_t m_state = 0xcbf29ce484222325u;
};

} // namespace test

#endif // CGAL_REGION_SEGMENTATION_TEST_DIGEST_H
