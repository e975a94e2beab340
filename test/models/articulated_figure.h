// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_ARTICULATED_FIGURE_H
#define CGAL_REGION_SEGMENTATION_TEST_ARTICULATED_FIGURE_H

#include "models/Labelled_model.h"

namespace segment_mesh {

inline constexpr const char* articulated_figure = "articulated_figure"; ///< its name

/// A figure of ten parts that meet in concave joints: trunk, head, and two of each of upper arm,
/// forearm, thigh and shin.
Labelled_model make_articulated_figure(const Making& making = {});

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_TEST_ARTICULATED_FIGURE_H
