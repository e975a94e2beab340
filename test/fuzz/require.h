// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_FUZZ_REQUIRE_H
#define CGAL_REGION_SEGMENTATION_TEST_FUZZ_REQUIRE_H

#include <cstdio>
#include <cstdlib>
#include <string>

/// Ends the run, which is a finding, unless `condition` holds.
inline void require(bool condition, const std::string& what)
{
  if (condition)
    return;
  std::fprintf(stderr, "does not hold: %s\n", what.c_str());
  std::abort();
}

#endif // CGAL_REGION_SEGMENTATION_TEST_FUZZ_REQUIRE_H
