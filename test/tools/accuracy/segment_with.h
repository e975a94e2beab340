// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_SEGMENT_WITH_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_SEGMENT_WITH_H

#include "Benchmark_mesh.h"
#include "Model_result.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace princeton_benchmark {

/// What a method makes of a mesh.
struct Timed_segmentation
{
  std::vector<int> labels; ///< of the faces by index
  std::size_t number_of_segments = 0, number_of_regions = 0;
  Stage_seconds seconds;
};

/// The wanted number of segments; empty: the method chooses it.
using Wanted_number = std::optional<std::size_t>;

using Segmenter = Timed_segmentation (*)(const Benchmark_mesh& mesh, Wanted_number number);

/// Which numbers of segments a method can be asked for.
enum class Numbers { GIVEN, CHOSEN, BOTH };

/// A segmentation method, with all its constants as they are by default.
struct Method
{
  std::string name;
  Segmenter segment;
  Numbers numbers;

  bool takes_number() const { return numbers != Numbers::CHOSEN; }
  bool chooses_number() const { return numbers != Numbers::GIVEN; }
};

/// `learned`, `visibility` and `two-step` of the library, `concave-angles`, and `sdf`, CGAL's own
/// segmentation.
const std::vector<Method>& methods();

/// \pre there is such a method
const Method& find_method(const std::string& name);

/// CGAL's segmentation by the shape diameter function (`CGAL::sdf_values()`,
/// `CGAL::segmentation_from_sdf_values()`), all parameters as they are by default: 25 rays in a
/// cone of 2/3 pi, 5 clusters, a smoothing of 0.26. Its clusters are not its segments: there is no
/// number to give. Regions are not known. \throws std::runtime_error if a face is not a triangle
Timed_segmentation segment_by_sdf(const Benchmark_mesh& mesh, Wanted_number);

/// The formula of MeshLib's hierarchical segmentation (2026): from single faces on, the regions are
/// merged first for which min(area) * (integral of the concave deviation along their section) /
/// length^2 is lowest. \pre `number` has a value
Timed_segmentation segment_by_concave_angles(const Benchmark_mesh& mesh, Wanted_number number);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_SEGMENT_WITH_H
