// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_COPIES_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_COPIES_H

#include "models.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace princeton_benchmark {

/// The shape of a mesh with other triangles, or in other numbers.
struct Copy
{
  Soup soup;
  std::vector<std::size_t> source;   ///< of each triangle: the one of the mesh that it comes from
  std::optional<std::size_t> person; ///< the only one whose labels the copy has; none: everyone's
};

/// The faces that `is_kept` says, by face. The points stay.
Copy with_faces(const Soup& soup, const std::vector<bool>& is_kept);

Point centroid_of(const Soup& soup, std::size_t face);

/// A kind of copies. Equal seeds give equal copies.
struct Copying
{
  std::string name;
  Copy (*copy)(const Model& model, unsigned seed);
};

/// What is learned from and scored beside each model: faces split into four; noise, the standard
/// deviation of each coordinate as a share of the mean edge length; a share of the edges left by
/// edge collapse; holes of ten faces, each around a random one.
const std::vector<Copying>& variants();

/// Copies whose segments should be those of the mesh: points, faces and first corners in another
/// order; a random rotation, scaling and translation; coordinates of five digits; noise, the
/// standard deviation of each coordinate as a share of the diagonal.
const std::vector<Copying>& equal_copies();

/// The model of a copy: each triangle has the labels of the one that it comes from. The number of
/// segments is that of the model, or of the only person, times the share of people's parts that are
/// left.
Model copied(const Model& model, const Copying& copying, unsigned seed);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_COPIES_H
