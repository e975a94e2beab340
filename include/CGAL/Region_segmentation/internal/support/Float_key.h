// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_FLOAT_KEY_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_FLOAT_KEY_H

#include <cstdint>
#include <cstring>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A non-negative float and an index as one number, ordered by the float, then by the index: it is
/// compared without a branch, and exchanged between threads at once. (The bits of such floats are
/// ordered like their values.)
using Float_key = std::uint64_t;

inline Float_key make_float_key(float value, std::uint32_t index)
{
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return (Float_key(bits) << 32) | index;
}

inline float value_of(Float_key key)
{
  const std::uint32_t bits = std::uint32_t(key >> 32);
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

inline std::uint32_t index_of(Float_key key)
{
  return std::uint32_t(key);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPPORT_FLOAT_KEY_H
