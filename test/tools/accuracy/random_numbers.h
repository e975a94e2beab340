// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_RANDOM_NUMBERS_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_RANDOM_NUMBERS_H

#include "models.h"

#include <CGAL/number_type_config.h>

#include <cmath>
#include <random>

namespace princeton_benchmark {

/// In [from, to), from the bits of the generator: the distributions of the standard library are not
/// prescribed.
inline double uniform(std::mt19937& random, double from = 0, double to = 1)
{
  return from + (to - from) * std::ldexp(double(random()), -32);
}

/// A random unit vector.
inline CGAL::Simple_cartesian<double>::Vector_3 direction(std::mt19937& random)
{
  const double z = uniform(random, -1, 1), angle = uniform(random, 0, 2 * CGAL_PI),
               radius = std::sqrt(1 - z * z);
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_RANDOM_NUMBERS_H
