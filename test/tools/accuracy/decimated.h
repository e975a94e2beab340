// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_DECIMATED_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_DECIMATED_H

#include "models/Labelled_model.h"

namespace princeton_benchmark {

/// The same parts with about `share` of the edges, of triangles: edges are collapsed by CGAL. A
/// face has the label of the face with the nearest centroid. \pre the faces can be oriented as a
/// manifold
segment_mesh::Labelled_model decimated(const segment_mesh::Labelled_model& model, double share);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_DECIMATED_H
