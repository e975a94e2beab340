// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_DRAW_COMPARISON_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_DRAW_COMPARISON_H

#include "Model_result.h"

#include "soup/Polygon_soup.h"

#include <vector>

namespace princeton_benchmark {

/// A small picture of a result, and to its right one of a truth from the same viewpoint. A segment
/// of the truth has the color of the segment of the result that it has the most faces in common
/// with.
Picture draw_comparison(const segment_mesh::Polygon_soup& soup, const std::vector<int>& result,
                        const std::vector<int>& truth);

/// Names the labels of `truth` after those of `result`: pairs with the most faces in common first,
/// each label once; what is left over gets numbers that no label of `result` has.
/// \pre the labels of `result` are 0 .. n-1
std::vector<std::size_t> match_labels(const std::vector<int>& result,
                                      const std::vector<int>& truth);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_DRAW_COMPARISON_H
