// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_ON_MESH_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_ON_MESH_H

#include "segmentation/Stage_clock.h"
#include "segmentation/run_segmentation.h"

#include <CGAL/number_type_config.h>

#include <CGAL/Region_segmentation/Methods/Learned_merging.h>
#include <CGAL/Region_segmentation/Methods/Smooth_faces.h>
#include <CGAL/Region_segmentation/Methods/Two_step.h>
#include <CGAL/Region_segmentation/Methods/Visibility_merging.h>
#include <CGAL/Region_segmentation/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/detect_feature_edges.h>
#include <CGAL/Region_segmentation/extract_feature_lines.h>
#include <CGAL/Region_segmentation/grow_regions.h>
#include <CGAL/Region_segmentation/segment.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstdint>
#include <functional>
#include <iterator>
#include <type_traits>

namespace segment_mesh {

namespace RS = CGAL::Region_segmentation;

/// Marks of edges in an array. Half the index of a halfedge is that of its edge, in all mesh types.
template <typename Mesh>
class Edge_mark_map
{
public:
  using key_type = typename boost::graph_traits<Mesh>::edge_descriptor;
  using value_type = bool;
  using reference = bool;
  using category = boost::read_write_property_map_tag;

  Edge_mark_map(const Mesh& mesh, std::vector<std::uint8_t>& marks) : m_mesh(&mesh), m_marks(&marks)
  {
  }

  friend bool get(const Edge_mark_map& map, const key_type& e) { return map.mark(e) != 0; }
  friend void put(const Edge_mark_map& map, const key_type& e, bool mark) { map.mark(e) = mark; }

private:
  std::uint8_t& mark(const key_type& e) const
  {
    const auto index = get(boost::halfedge_index, *m_mesh);
    return (*m_marks)[std::size_t(get(index, halfedge(e, *m_mesh))) / 2];
  }

  const Mesh* m_mesh;
  std::vector<std::uint8_t>* m_marks;
};

template <typename Mesh>
auto make_face_map(const Mesh& mesh, std::vector<std::size_t>& labels)
{
  return boost::make_iterator_property_map(labels.begin(), get(boost::face_index, mesh));
}

/// The feature edges as lines from junction to junction, without those that end inside the surface.
template <typename Mesh>
std::vector<std::vector<std::size_t>> feature_lines(const Mesh& mesh, Edge_mark_map<Mesh> marks)
{
  std::vector<std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor>> lines;
  RS::extract_feature_lines(mesh, marks, std::back_inserter(lines));

  const auto vertex_index = get(boost::vertex_index, mesh);
  std::vector<std::vector<std::size_t>> result;
  for (const auto& line : lines) {
    std::vector<std::size_t>& indices = result.emplace_back();
    for (const auto v : line)
      indices.push_back(std::size_t(get(vertex_index, v)));
  }
  return result;
}

template <typename Mesh>
void describe_regions(const Mesh& mesh, Segmentation& result)
{
  const auto graph =
    RS::build_region_adjacency_graph(mesh, make_face_map(mesh, result.region_of_face));
  result.regions.resize(result.number_of_regions);
  for (std::size_t f = 0; f < result.region_of_face.size(); ++f) {
    Region& region = result.regions[result.region_of_face[f]];
    ++region.number_of_faces;
    region.segment = result.segment_of_face[f];
  }
  for (auto range = vertices(graph); range.first != range.second; ++range.first) {
    result.regions[*range.first].area = graph[*range.first].area;
    result.regions[*range.first].perimeter = graph[*range.first].perimeter;
  }
  for (auto range = edges(graph); range.first != range.second; ++range.first) {
    const auto section = *range.first;
    result.sections.push_back({{source(section, graph), target(section, graph)},
                               graph[section].number_of_edges,
                               graph[section].length,
                               graph[section].mean_angle()});
  }
}

/// Fills everything but the details of `result`, whose arrays have their sizes.
template <typename Mesh, typename SegmentationMethod>
void segment_by(const SegmentationMethod& method, const Mesh& mesh, const Segmentation_settings& settings,
                const Progress_listener& listener, Segmentation& result)
{
  RS::Merge_tree tree;
  Stage_clock clock(listener);
  const auto segment = [&](const auto& np) {
    return RS::segment<CGAL::Parallel_tag>(mesh, make_face_map(mesh, result.segment_of_face),
                                           np.method(method)
                                             .region_map(make_face_map(mesh, result.region_of_face))
                                             .merge_tree(tree)
                                             .visitor(std::ref(clock)));
  };
  if (settings.number_of_segments)
    result.number_of_segments = segment(RS::parameters::number_of_segments(*settings.number_of_segments));
  else if constexpr (!std::is_same<decltype(method.chooser), RS::No_number_chooser>::value)
    result.number_of_segments = segment(RS::parameters::default_values());
  result.seconds = clock.seconds();
  result.stages = clock.stages();
  result.number_of_regions = tree.number_of_regions();
  // Where more segments are wanted than there are regions, regions are split.
  if (result.number_of_segments > result.number_of_regions) {
    result.region_of_face = result.segment_of_face;
    result.number_of_regions = result.number_of_segments;
  }
}

/// The feature edges that separate regions, as lines.
template <typename Mesh>
std::vector<std::vector<std::size_t>> feature_lines_of_regions(const Mesh& mesh, const Feature_settings& features)
{
  std::vector<std::uint8_t> marks(num_halfedges(mesh) / 2);
  const Edge_mark_map<Mesh> is_feature(mesh, marks);
  std::vector<std::size_t> regions(num_faces(mesh));
  RS::detect_feature_edges(
    mesh, is_feature, RS::parameters::maximum_angle(features.maximum_angle).feature_convexity(features.convexity));
  RS::grow_regions(mesh, is_feature, make_face_map(mesh, regions));
  return feature_lines(mesh, is_feature);
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

  if (settings.detail == Detail::ALL) {
    if (result.features)
      result.feature_lines = feature_lines_of_regions(mesh, *result.features);
    describe_regions(mesh, result);
  }
  return result;
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_ON_MESH_H
