// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_METHOD_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_METHOD_H

#include "segmentation/Stage_clock.h"
#include "segmentation/run_segmentation.h"

#include <CGAL/number_type_config.h>

#include <CGAL/Region_segmentation/Methods/Learned_merging.h>
#include <CGAL/Region_segmentation/Methods/Two_step.h>
#include <CGAL/Region_segmentation/Methods/Visibility_merging.h>
#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/Region_segmentation/segment.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

namespace segment_mesh {

namespace RS = CGAL::Region_segmentation;

template <typename Chooser, typename = void>
constexpr bool has_largest_number = false;
template <typename Chooser>
constexpr bool
  has_largest_number<Chooser, std::void_t<decltype(std::declval<const Chooser&>().largest_number(
                                std::declval<const RS::Merge_tree&>()))>> = true;

/// The number that was chosen, if the chooser would not choose a larger one, but the tree has more
/// regions than it, and fewer components.
template <typename Chooser>
std::optional<std::size_t> largest_number(const Chooser& chooser, std::size_t number,
                                          const RS::Merge_tree& tree)
{
  if constexpr (has_largest_number<Chooser>) {
    const std::size_t number_of_components = tree.number_of_regions() - tree.merges().size();
    if (number == chooser.largest_number(tree) && number_of_components < number &&
        number < tree.number_of_regions())
      return number;
  }
  return std::nullopt;
}

/// Fills `result`. `segment(np, result)`: calls the library with more named parameters: its input
/// and its maps
template <typename SegmentationMethod, typename Segment>
void segment_by(const SegmentationMethod& method, const Segment& segment,
                const Segmentation_settings& settings, const Progress_listener& listener,
                Segmentation& result)
{
  Stage_clock clock(listener);
  const auto segment_with = [&](const auto& np) {
    return segment(np.method(method)
                     .merge_tree(result.tree)
                     .component_links(settings.links == Component_links::FOUND)
                     .visitor(std::ref(clock)),
                   result);
  };
  if (settings.number_of_segments)
    result.number_of_segments = segment_with(
      RS::parameters::number_of_segments(*settings.number_of_segments));
  else if constexpr (!std::is_same<SegmentationMethod, RS::Two_step>::value) {
    result.number_of_segments = segment_with(RS::parameters::default_values());
    result.largest_number = largest_number(method.chooser, result.number_of_segments, result.tree);
  }
  // Where more segments are wanted than there are regions, regions are split.
  if (result.number_of_segments > result.tree.number_of_regions()) {
    result.region_of_face = result.segment_of_face;
    result.tree = RS::Merge_tree(result.number_of_segments);
  }
  result.number_of_regions = result.tree.number_of_regions();
  result.seconds = clock.seconds();
  result.stages = clock.stages();
}

template <typename Segment>
Segmentation run_method(std::size_t number_of_faces, const Segment& segment,
                        const Segmentation_settings& settings, const Progress_listener& listener)
{
  Segmentation result;
  result.segment_of_face.resize(number_of_faces);
  result.region_of_face.resize(number_of_faces);
  switch (settings.method) {
  case Method::TWO_STEP: {
    result.features = {settings.maximum_angle.value_or(RS::default_maximum_angle),
                       settings.features};
    RS::Two_step method;
    method.maximum_angle = result.features->maximum_angle;
    method.feature_convexity = result.features->convexity;
    segment_by(method, segment, settings, listener, result);
    break;
  }
  case Method::SMOOTH_FACES: {
    RS::Smooth_faces method;
    method.tolerance = settings.tolerance;
    segment_by(method, segment, settings, listener, result);
    break;
  }
  case Method::VISIBILITY:
    segment_by(RS::Visibility_merging(), segment, settings, listener, result);
    break;
  case Method::LEARNED:
    segment_by(RS::Learned_merging(), segment, settings, listener, result);
    break;
  }
  return result;
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_METHOD_H
