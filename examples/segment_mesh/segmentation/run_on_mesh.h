// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_ON_MESH_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_ON_MESH_H

#include "segmentation/Stage_clock.h"
#include "segmentation/nest_regions.h"
#include "segmentation/run_segmentation.h"

#include <CGAL/number_type_config.h>

#include <CGAL/Region_segmentation/Methods/Learned_merging.h>
#include <CGAL/Region_segmentation/Methods/Smooth_faces.h>
#include <CGAL/Region_segmentation/Methods/Two_step.h>
#include <CGAL/Region_segmentation/Methods/Visibility_merging.h>
#include <CGAL/Region_segmentation/segment.h>
#include <CGAL/Region_segmentation/smooth_borders.h>

#include <boost/graph/properties.hpp>
#include <boost/property_map/property_map.hpp>

#include <functional>
#include <type_traits>

namespace segment_mesh {

namespace RS = CGAL::Region_segmentation;

template <typename Mesh>
auto make_face_map(const Mesh& mesh, std::vector<std::size_t>& labels)
{
  return boost::make_iterator_property_map(labels.begin(), get(boost::face_index, mesh));
}

template <typename Mesh>
void smooth_borders(const Mesh& mesh, Stage_clock& clock, Segmentation& result)
{
  std::vector<std::size_t> segment_of_region(result.number_of_regions);
  for (std::size_t f = 0; f < result.region_of_face.size(); ++f)
    segment_of_region[result.region_of_face[f]] = result.segment_of_face[f];
  RS::smooth_borders<CGAL::Parallel_tag>(mesh, make_face_map(mesh, result.segment_of_face),
                                         RS::parameters::visitor(std::ref(clock)));
  nest_regions(mesh, segment_of_region, result);
}

/// Fills `result`, whose arrays have their sizes.
template <typename Mesh, typename SegmentationMethod>
void segment_by(const SegmentationMethod& method, const Mesh& mesh, const Segmentation_settings& settings,
                const Progress_listener& listener, Segmentation& result)
{
  Stage_clock clock(listener);
  const auto segment = [&](const auto& np) {
    return RS::segment<CGAL::Parallel_tag>(mesh, make_face_map(mesh, result.segment_of_face),
                                           np.method(method)
                                             .region_map(make_face_map(mesh, result.region_of_face))
                                             .merge_tree(result.tree)
                                             .visitor(std::ref(clock)));
  };
  if (settings.number_of_segments)
    result.number_of_segments = segment(RS::parameters::number_of_segments(*settings.number_of_segments));
  else if constexpr (!std::is_same<decltype(method.chooser), RS::No_number_chooser>::value)
    result.number_of_segments = segment(RS::parameters::default_values());
  // Where more segments are wanted than there are regions, regions are split.
  if (result.number_of_segments > result.tree.number_of_regions()) {
    result.region_of_face = result.segment_of_face;
    result.tree = RS::Merge_tree(result.number_of_segments);
  }
  result.number_of_regions = result.tree.number_of_regions();
  if (settings.borders == Border_treatment::SMOOTHING)
    smooth_borders(mesh, clock, result);
  result.seconds = clock.seconds();
  result.stages = clock.stages();
}

/// \pre the indices of faces and vertices are those of the soup that the mesh was made of
template <typename Mesh>
Segmentation run_on_mesh(const Mesh& mesh, const Segmentation_settings& settings,
                         const Progress_listener& listener)
{
  Segmentation result;
  result.segment_of_face.resize(num_faces(mesh));
  result.region_of_face.resize(num_faces(mesh));
  if (settings.method == Method::TWO_STEP) {
    result.features = {settings.maximum_angle.value_or(RS::default_maximum_angle), settings.features};
    RS::Two_step method;
    method.initializer.maximum_angle = result.features->maximum_angle;
    method.initializer.feature_convexity = result.features->convexity;
    segment_by(method, mesh, settings, listener, result);
  } else if (settings.method == Method::SMOOTH_FACES)
    segment_by(RS::Smooth_faces(), mesh, settings, listener, result);
  else if (settings.method == Method::VISIBILITY)
    segment_by(RS::Visibility_merging(), mesh, settings, listener, result);
  else
    segment_by(RS::Learned_merging(), mesh, settings, listener, result);

  return result;
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_ON_MESH_H
