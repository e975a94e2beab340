// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_SHEETS_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_SHEETS_H

#include "models.h"

#include <string>
#include <vector>

namespace princeton_benchmark {

/// An open surface that is one part.
struct Sheet
{
  std::string kind; ///< Plane, Hill, Tube, or Terrain
  Model model;
};

/// Twenty sheets of four kinds, of random shape and fineness: flat ones; gentle hills; open tubes,
/// cones and parts of them, seen from inside or outside; waves of many lengths. Equal seeds give
/// equal sheets.
std::vector<Sheet> make_sheets(unsigned seed);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_SHEETS_H
