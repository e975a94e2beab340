// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_METHODS_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_METHODS_H

#include "models.h"

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace princeton_benchmark {

/// A segmentation method, with its constants as they are by default.
struct Method
{
  /// Writes the labels of the faces and returns the number of segments. No wanted number: the
  /// method chooses it. \pre the method can do this
  std::function<std::size_t(const Mesh& mesh, std::optional<std::size_t> wanted,
                            std::vector<int>& labels)>
    segment;
  bool takes_number, chooses_number;
};

/// By their names: `learned`, `visibility` and `two-step` of the library;
///
/// `concave-angles`, the formula of MeshLib's hierarchical segmentation (2026): from single faces
/// on, the regions are merged first for which min(area) * (integral of the concave deviation along
/// their section) / length^2 is lowest;
///
/// `sdf`, CGAL's segmentation by the shape diameter function (`CGAL::sdf_values()`,
/// `CGAL::segmentation_from_sdf_values()`), whose clusters are not its segments: there is no number
/// to give.
///
/// `number_of_draws`: of `learned` and `visibility`; 0: their own
std::map<std::string, Method> methods(std::size_t number_of_draws);

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_METHODS_H
