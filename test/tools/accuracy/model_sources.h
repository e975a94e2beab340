// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_MODEL_SOURCES_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_MODEL_SOURCES_H

#include "Princeton_data.h"
#include "model_variants.h"

#include "soup/Polygon_soup.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace princeton_benchmark {

/// What a result is compared with.
struct Truth
{
  std::string name;
  std::vector<int> labels; ///< of each face, in the order of the file
  std::size_t number_of_segments = 0;
};

/// A model in memory.
struct Model
{
  segment_mesh::Polygon_soup soup;
  std::size_t number_of_segments = 0; ///< the number k that a method is given
  std::vector<Truth> truths;
};

/// Where a model comes from. It is loaded by the thread that works on it.
struct Model_source
{
  std::string name, category;
  std::function<Model()> load; ///< \throws std::exception with a message that names the file
};

/// All models of a copy of the Princeton benchmark, by number. \pre `data` lives as long as the
/// result
std::vector<Model_source> princeton_sources(const Princeton_data& data);

/// Furniture: each `KIND_NAME.off` of a folder with the labels of its faces in `KIND_NAME.seg`, one
/// truth; by name, the category is the kind. The number that a method is given is that of the parts
/// of more than .2 % of the faces.
/// \throws std::runtime_error if there is none
std::vector<Model_source> furniture_sources(const std::filesystem::path& folder);

/// The models that segment_mesh can make, each a category of its own with one truth.
std::vector<Model_source> procedural_sources();

/// The same in every variant, which is their category.
std::vector<Model_source> variant_sources(const std::vector<Variant>& variants);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_MODEL_SOURCES_H
