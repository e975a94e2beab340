// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_LABELLED_MODEL_H
#define CGAL_REGION_SEGMENTATION_TEST_LABELLED_MODEL_H

#include "soup/Polygon_soup.h"

#include <cstddef>
#include <string>
#include <vector>

namespace segment_mesh {

/// A closed mesh whose parts are known, because it was made of them.
struct Labelled_model
{
  std::string name;
  Polygon_soup soup;
  std::vector<std::size_t> labels; ///< the part of each face, below `number_of_parts`
  std::size_t number_of_parts = 0;
};

/// How a model is made.
struct Making
{
  double fineness = 1; ///< faces along a line, relative to the usual ones
  double noise = 1;    ///< relative to the usual one of the model, which may be none
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_TEST_LABELLED_MODEL_H
