// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_FUZZ_BYTES_H
#define CGAL_REGION_SEGMENTATION_TEST_FUZZ_BYTES_H

#include <cstddef>
#include <cstdint>
#include <cstring>

/// The bytes of a fuzzer as a source of decisions; zeros after their end.
class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size)
    : m_at(data)
    , m_end(data + size)
  {}

  bool empty() const { return m_at == m_end; }
  std::uint8_t byte() { return empty() ? std::uint8_t(0) : *m_at++; }
  /// From 0 to `n` - 1. \pre n <= 256
  std::size_t below(std::size_t n) { return byte() % n; }

  /// Any value of double: a small multiple of a power of ten from the ends and the middle of the
  /// range, or any bits.
  double number()
  {
    constexpr double scales[] = {1,     1,      1,     1,      1e-3,  1e3, 1e-160,
                                 1e160, 1e-308, 1e306, 5e-324, 1e-12, 1e12};
    const std::size_t choice = below(sizeof scales / sizeof *scales + 1);
    if (choice < sizeof scales / sizeof *scales)
      return scales[choice] * (int(byte()) - 128);
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i)
      bits = bits << 8 | byte();
    double value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

private:
  const std::uint8_t *m_at, *m_end;
};

#endif // CGAL_REGION_SEGMENTATION_TEST_FUZZ_BYTES_H
