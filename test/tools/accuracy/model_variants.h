// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_MODEL_VARIANTS_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_MODEL_VARIANTS_H

#include "models/procedural_models.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace princeton_benchmark {

/// \name The same parts on another mesh
/// Each face belongs to the part of the face that it comes from.
/// @{

/// Moves every coordinate at random, evenly, with a standard deviation of `share` of the mean edge
/// length.
segment_mesh::Labelled_model with_noise(segment_mesh::Labelled_model model, double share,
                                        std::uint32_t seed);

/// Each triangle becomes four, each quad four quads, at the middles of edges: the same surface.
segment_mesh::Labelled_model split_into_four(const segment_mesh::Labelled_model& model);

/// Gives about half of the pairs of triangles within a part, where that keeps the surface to 30
/// degrees and makes no edge longer than twice the old one, their other diagonal. Quads are split
/// first.
segment_mesh::Labelled_model with_flipped_edges(segment_mesh::Labelled_model model,
                                                std::uint32_t seed);

/// Without about `share` of the faces, at least: holes of ten faces, each around a random one.
/// Points are kept.
segment_mesh::Labelled_model with_holes(const segment_mesh::Labelled_model& model, double share,
                                        std::uint32_t seed);
/// @}

/// A variant of all models.
struct Variant
{
  std::string name;
  std::function<segment_mesh::Labelled_model(const segment_mesh::Model_recipe&)> make;
};

/// As it is, without noise, with noise, finer, coarser, and triangulated otherwise. `seed`: of what
/// is random among them.
std::vector<Variant> model_variants(std::uint32_t seed);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_MODEL_VARIANTS_H
