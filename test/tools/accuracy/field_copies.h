// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_FIELD_COPIES_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_FIELD_COPIES_H

#include "copies.h"

#include <vector>

namespace princeton_benchmark {

/// What a depth camera sees from a random direction: the faces whose centroids nothing hides, and
/// that are not seen edge on. Pieces of less than 2 % of the faces are left out.
Copy seen_from_one_side(const Soup& soup, unsigned seed);

/// The faces on one side of a random plane through the mean of the vertices.
Copy cut_in_half(const Soup& soup, unsigned seed);

/// A model as it is assembled of closed pieces that cross: the parts that one of the people sees,
/// who alone judges it. Of the parts one of four, with an odd seed three of four, are two to four
/// pieces each, by the nearest of random faces; of the pairs of adjacent pieces, one of eight is
/// one piece. Each piece is closed by fans, whose triangles come from the faces beside them, and
/// scaled by 1.01 about the mean of its vertices.
Copy in_closed_pieces(const Model& model, unsigned seed);

/// These, which are learned from and scored beside the variants: a model as the field has it.
const std::vector<Copying>& field_copies();

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_FIELD_COPIES_H
