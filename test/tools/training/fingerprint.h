// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_FINGERPRINT_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_FINGERPRINT_H

#include "Training_rows.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

namespace train_merge_cost {

/// A hash of training rows, in hexadecimal digits: FNV-1a of 64 bits over features, probabilities
/// and weights, the latter two as multiples of 2^-20.
inline std::string fingerprint(const Training_rows& rows)
{
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&hash](std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i)
      hash = (hash ^ (value >> (8 * i) & 0xff)) * 0x100000001b3u;
  };
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (const Model::Feature x : rows.features[r])
      add(std::uint16_t(x), 2);
    add(std::uint64_t(std::llround(std::ldexp(rows.probabilities[r], 20))), 4);
    add(std::uint64_t(std::llround(std::ldexp(rows.weights[r], 20))), 4);
  }
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

} // namespace train_merge_cost

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_TRAINING_FINGERPRINT_H
