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

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace segment_mesh {

namespace RS = CGAL::Region_segmentation;

template <typename Mesh>
auto make_face_map(const Mesh& mesh, std::vector<std::size_t>& labels)
{
  return boost::make_iterator_property_map(labels.begin(), get(boost::face_index, mesh));
}

/// Whether an edge is one of a sorted list of pairs of points.
template <typename Mesh>
struct Edge_is_constrained_map
{
  using key_type = typename boost::graph_traits<Mesh>::edge_descriptor;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;

  friend bool get(const Edge_is_constrained_map& map, const key_type& e)
  {
    if (map.edges->empty())
      return false;
    const auto index = get(boost::vertex_index, *map.mesh);
    Vertex_pair edge = {get(index, source(e, *map.mesh)), get(index, target(e, *map.mesh))};
    std::sort(edge.begin(), edge.end());
    return std::binary_search(map.edges->begin(), map.edges->end(), edge);
  }

  const Mesh* mesh;
  const std::vector<Vertex_pair>* edges;
};

/// The seeds of faces; none if the list is empty.
template <typename Mesh>
struct Face_seed_map
{
  using key_type = typename boost::graph_traits<Mesh>::face_descriptor;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::readable_property_map_tag;

  friend std::size_t get(const Face_seed_map& map, const key_type& f)
  {
    return map.seeds->empty() ? no_seed : (*map.seeds)[get(boost::face_index, *map.mesh, f)];
  }

  const Mesh* mesh;
  const std::vector<std::size_t>* seeds;
};

template <typename Chooser, typename = void>
constexpr bool has_largest_number = false;
template <typename Chooser>
constexpr bool has_largest_number<
  Chooser, std::void_t<decltype(std::declval<const Chooser&>().largest_number(std::declval<const RS::Merge_tree&>()))>> = true;

/// The number that was chosen, if the chooser would not choose a larger one, but the tree has more regions than it, and
/// fewer components.
template <typename Chooser>
std::optional<std::size_t> largest_number(const Chooser& chooser, std::size_t number, const RS::Merge_tree& tree)
{
  if constexpr (has_largest_number<Chooser>) {
    const std::size_t number_of_components = tree.number_of_regions() - tree.merges().size();
    if (number == chooser.largest_number(tree) && number_of_components < number && number < tree.number_of_regions())
      return number;
  }
  return std::nullopt;
}

template <typename Mesh>
void smooth_borders(const Mesh& mesh, const Edge_is_constrained_map<Mesh>& constrained, Stage_clock& clock,
                    Segmentation& result)
{
  std::vector<std::size_t> segment_of_region(result.number_of_regions);
  for (std::size_t f = 0; f < result.region_of_face.size(); ++f)
    segment_of_region[result.region_of_face[f]] = result.segment_of_face[f];
  RS::smooth_borders<CGAL::Parallel_tag>(mesh, make_face_map(mesh, result.segment_of_face),
                                         RS::parameters::visitor(std::ref(clock)).edge_is_constrained_map(constrained));
  nest_regions(mesh, segment_of_region, result);
}

/// Fills `result`, whose arrays have their sizes.
template <typename Mesh, typename SegmentationMethod>
void segment_by(const SegmentationMethod& method, const Mesh& mesh, const Marks& marks, const Segmentation_settings& settings,
                const Progress_listener& listener, Segmentation& result)
{
  Stage_clock clock(listener);
  const Edge_is_constrained_map<Mesh> constrained{&mesh, &marks.constrained_edges};
  const Face_seed_map<Mesh> seeds{&mesh, &marks.seed_of_face};
  const auto segment = [&](const auto& np) {
    return RS::segment<CGAL::Parallel_tag>(mesh, make_face_map(mesh, result.segment_of_face),
                                           np.method(method)
                                             .region_map(make_face_map(mesh, result.region_of_face))
                                             .merge_tree(result.tree)
                                             .edge_is_constrained_map(constrained)
                                             .face_seed_map(seeds)
                                             .visitor(std::ref(clock)));
  };
  if (settings.number_of_segments)
    result.number_of_segments = segment(RS::parameters::number_of_segments(*settings.number_of_segments));
  else if constexpr (!std::is_same<decltype(method.chooser), RS::No_number_chooser>::value) {
    result.number_of_segments = segment(RS::parameters::default_values());
    result.largest_number = largest_number(method.chooser, result.number_of_segments, result.tree);
  }
  // Where more segments are wanted than there are regions, regions are split.
  if (result.number_of_segments > result.tree.number_of_regions()) {
    result.region_of_face = result.segment_of_face;
    result.tree = RS::Merge_tree(result.number_of_segments);
  }
  result.number_of_regions = result.tree.number_of_regions();
  if (settings.borders == Border_treatment::SMOOTHING)
    smooth_borders(mesh, constrained, clock, result);
  result.seconds = clock.seconds();
  result.stages = clock.stages();
}

/// \pre the indices of faces and vertices are those of the soup that the mesh was made of
template <typename Mesh>
Segmentation run_on_mesh(const Mesh& mesh, const Marks& marks, const Segmentation_settings& settings,
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
    segment_by(method, mesh, marks, settings, listener, result);
  } else if (settings.method == Method::SMOOTH_FACES)
    segment_by(RS::Smooth_faces(), mesh, marks, settings, listener, result);
  else if (settings.method == Method::VISIBILITY)
    segment_by(RS::Visibility_merging(), mesh, marks, settings, listener, result);
  else
    segment_by(RS::Learned_merging(), mesh, marks, settings, listener, result);

  return result;
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_ON_MESH_H
