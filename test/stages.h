// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_STAGES_H
#define CGAL_REGION_SEGMENTATION_TEST_STAGES_H

// The stages on a face graph with property maps: what is read of the mesh, and written to it,
// around the stages of a `Surface`. `np` are the named parameters of make_surface().

#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Support/parameters.h>
#include <CGAL/Region_segmentation/Surface/edge_values.h>
#include <CGAL/Region_segmentation/Surface/face_values.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/Region_segmentation/Two_step/detect_feature_edges.h>
#include <CGAL/Region_segmentation/Two_step/extract_feature_lines.h>
#include <CGAL/Region_segmentation/Two_step/grow_regions.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

namespace test {

struct Feature_options
{
  double maximum_angle = CGAL::Region_segmentation::default_maximum_angle;
  CGAL::Region_segmentation::Feature_convexity
    convexity = CGAL::Region_segmentation::Feature_convexity::CONCAVE;
};

template <typename ConcurrencyTag = CGAL::Sequential_tag, typename NamedParameters>
CGAL::Region_segmentation::Execution execution_of(const NamedParameters& np)
{
  using namespace CGAL::Region_segmentation::internal;
  return make_execution<ConcurrencyTag>(pack(np));
}

template <
  typename ConcurrencyTag = CGAL::Sequential_tag, typename Mesh, typename EdgeMap,
  typename NamedParameters = CGAL::Region_segmentation::parameters::Default_named_parameters>
std::size_t detect_feature_edges(
  const Mesh& mesh, EdgeMap map, const Feature_options& options = {},
  const NamedParameters& np = CGAL::Region_segmentation::parameters::default_values())
{
  namespace RS = CGAL::Region_segmentation;
  const RS::Surface surface = RS::make_surface<ConcurrencyTag>(mesh, np);
  const auto marks = RS::detect_feature_edges(surface, options.maximum_angle, options.convexity,
                                              execution_of<ConcurrencyTag>(np).stage("features"));
  return RS::write_edge_values(mesh, surface, marks, map);
}

/// Outputs the lines as vectors of vertices of the mesh.
template <
  typename Mesh, typename EdgeMap, typename OutputIterator,
  typename NamedParameters = CGAL::Region_segmentation::parameters::Default_named_parameters>
OutputIterator extract_feature_lines(
  const Mesh& mesh, EdgeMap map, OutputIterator output,
  std::size_t minimum_length = std::size_t(-1),
  const NamedParameters& np = CGAL::Region_segmentation::parameters::default_values())
{
  namespace RS = CGAL::Region_segmentation;
  const RS::Surface surface = RS::make_surface(mesh, np);
  auto marks = RS::edge_values(mesh, surface, map);
  std::vector<std::vector<RS::Surface::Index>> lines;
  RS::extract_feature_lines(surface, marks, std::back_inserter(lines), minimum_length);
  RS::write_edge_values(mesh, surface, marks, map);
  const std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> vertex_of(
    vertices(mesh).begin(), vertices(mesh).end());
  for (const auto& line : lines) {
    std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> polyline;
    for (const RS::Surface::Index v : line)
      polyline.push_back(vertex_of[v]);
    *output++ = polyline;
  }
  return output;
}

/// Clears the feature edges between two faces of one region. Returns the number of regions.
template <
  typename ConcurrencyTag = CGAL::Sequential_tag, typename Mesh, typename EdgeMap,
  typename RegionMap,
  typename NamedParameters = CGAL::Region_segmentation::parameters::Default_named_parameters>
std::size_t
grow_regions(const Mesh& mesh, EdgeMap map, RegionMap region_map,
             const NamedParameters& np = CGAL::Region_segmentation::parameters::default_values())
{
  namespace RS = CGAL::Region_segmentation;
  const RS::Surface surface = RS::make_surface<ConcurrencyTag>(mesh, np);
  auto marks = RS::edge_values(mesh, surface, map);
  const RS::Partition regions = RS::grow_regions(surface, marks,
                                                 execution_of<ConcurrencyTag>(np).stage("regions"));
  for (std::size_t a = 0; a < marks.size(); ++a)
    marks[a] &= regions[surface.lower_face(a)] != regions[surface.higher_face(a)];
  RS::write_face_values(mesh, regions, region_map);
  RS::write_edge_values(mesh, surface, marks, map);
  return regions.number_of_parts();
}

template <
  typename RegionData = CGAL::Region_segmentation::Region_geometry,
  typename SectionData = CGAL::Region_segmentation::Section_geometry, typename Mesh,
  typename RegionMap,
  typename NamedParameters = CGAL::Region_segmentation::parameters::Default_named_parameters>
auto build_region_adjacency_graph(
  const Mesh& mesh, RegionMap region_map,
  const NamedParameters& np = CGAL::Region_segmentation::parameters::default_values())
{
  namespace RS = CGAL::Region_segmentation;
  const RS::Surface surface = RS::make_surface(mesh, np);
  return RS::build_region_adjacency_graph<RegionData, SectionData>(
    surface, RS::Partition::from_labels(RS::face_values(mesh, region_map)),
    execution_of(np).stage("graph"));
}

} // namespace test

#endif // CGAL_REGION_SEGMENTATION_TEST_STAGES_H
