// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENTATION_SETTINGS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENTATION_SETTINGS_H

#include <CGAL/Region_segmentation/detect_feature_edges.h>

#include <cstddef>
#include <optional>

namespace segment_mesh {

enum class Method { TWO_STEP, VISIBILITY, LEARNED, SMOOTH_FACES };

/// What becomes of the borders that a method gives.
enum class Border_treatment { NONE, SMOOTHING };

/// Whether components that touch or are near each other are adjacent.
enum class Component_links { NONE, FOUND };

struct Segmentation_settings
{
  Method method = Method::LEARNED;
  std::optional<std::size_t> number_of_segments; ///< if empty, the method chooses: `TWO_STEP`
                                                 ///< cannot
  /// Which edges can be features, of a method that has them.
  CGAL::Region_segmentation::Feature_convexity
    features = CGAL::Region_segmentation::Feature_convexity::CONCAVE;
  std::optional<double> maximum_angle; ///< in degrees; the method's own if empty
  double tolerance = 0; ///< of `SMOOTH_FACES`, in units of the mesh; 0: found from the mesh
  Border_treatment borders = Border_treatment::NONE;
  Component_links links = Component_links::FOUND;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_SEGMENTATION_SETTINGS_H
