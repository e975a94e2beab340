// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_ON_MESH_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_ON_MESH_H

#include "segmentation/Stage_clock.h"
#include "segmentation/run_segmentation.h"

#include <CGAL/number_type_config.h>

#include <CGAL/Region_segmentation/Number_from_costs.h>
#include <CGAL/Region_segmentation/best.h>
#include <CGAL/Region_segmentation/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/choose_feature_convexity.h>
#include <CGAL/Region_segmentation/extract_feature_lines.h>
#include <CGAL/Region_segmentation/segment.h>
#include <CGAL/Region_segmentation/two_step.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstdint>
#include <functional>
#include <iterator>

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

/// The labels for one number of segments, from a tree that serves all.
inline void cut_tree(const RS::Merge_tree& tree, std::size_t number_of_segments,
                     Segmentation& result)
{
  const RS::Merge_tree::Segmentation segments = tree.cut_at_count(number_of_segments);
  for (std::size_t f = 0; f < result.segment_of_face.size(); ++f)
    result.segment_of_face[f] = segments.of_region[result.region_of_face[f]];
  result.number_of_segments = segments.number_of_segments;
}

/// Fills everything but the details of `result`, whose arrays have their sizes.
template <typename Mesh, typename Policy>
void segment_by(const Policy& policy, const Mesh& mesh, const Segmentation_settings& settings,
                Edge_mark_map<Mesh> feature_map, const Progress_listener& listener,
                Segmentation& result)
{
  RS::Merge_tree tree;
  Stage_clock clock(listener);
  result.number_of_segments =
    RS::segment<CGAL::Parallel_tag>(
      mesh, make_face_map(mesh, result.segment_of_face),
      RS::parameters::number_of_segments(settings.number_of_segments.value_or(1))
        .merging_policy(policy)
        .maximum_angle(result.maximum_angle)
        .feature_convexity(result.features)
        .region_map(make_face_map(mesh, result.region_of_face))
        .edge_is_feature_map(feature_map)
        .merge_tree(std::ref(tree))
        .visitor(std::ref(clock)));
  if (!settings.number_of_segments)
    cut_tree(tree, RS::Number_from_costs()(tree), result);
  result.seconds = clock.seconds();
  result.stages = clock.stages();
  result.number_of_regions = tree.number_of_regions();
  // Where more segments are wanted than there are regions, regions are split.
  if (result.number_of_segments > result.number_of_regions) {
    result.region_of_face = result.segment_of_face;
    result.number_of_regions = result.number_of_segments;
  }
}

/// Needs `result.maximum_angle`.
template <typename Mesh>
void choose_features(const Mesh& mesh, const Segmentation_settings& settings, Segmentation& result)
{
  if (settings.features) {
    result.features = *settings.features;
    return;
  }
  const RS::Feature_convexity_choice choice = RS::choose_feature_convexity(
    mesh, RS::parameters::maximum_angle(result.maximum_angle));
  result.features = choice.convexity;
  result.flatness_beside_creases = choice.flatness_beside_creases;
}

/// \pre the indices of faces and vertices are those of the soup that the mesh was made of
template <typename Mesh>
Segmentation run_on_mesh(const Mesh& mesh, const Segmentation_settings& settings,
                         const Progress_listener& listener)
{
  Segmentation result;
  result.maximum_angle = settings.maximum_angle.value_or(RS::internal::default_maximum_angle);
  choose_features(mesh, settings, result);
  result.segment_of_face.resize(num_faces(mesh));
  result.region_of_face.resize(num_faces(mesh));
  std::vector<std::uint8_t> marks(num_halfedges(mesh) / 2);
  const Edge_mark_map<Mesh> feature_map(mesh, marks);
  if (settings.method == Method::TWO_STEP)
    segment_by(RS::Two_step(), mesh, settings, feature_map, listener, result);
  else
    segment_by(RS::Best(), mesh, settings, feature_map, listener, result);

  if (settings.detail == Detail::ALL) {
    result.feature_lines = feature_lines(mesh, feature_map);
    describe_regions(mesh, result);
  }
  return result;
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_RUN_ON_MESH_H
