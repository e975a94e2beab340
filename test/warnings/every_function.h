// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_WARNINGS_EVERY_FUNCTION_H
#define CGAL_REGION_SEGMENTATION_TEST_WARNINGS_EVERY_FUNCTION_H

// Every function and every part of a method once, so that a compiler sees all of the library: for
// warnings and for other versions of CGAL, language standards and compilers.

#include <CGAL/Region_segmentation/Evaluation/evaluation.h>
#include <CGAL/Region_segmentation/Evaluation/labels.h>
#include <CGAL/Region_segmentation/Segments/compute_segment_topology.h>
#include <CGAL/Region_segmentation/Segments/find_nearest_faces.h>
#include <CGAL/Region_segmentation/Segments/segment_borders.h>
#include <CGAL/Region_segmentation/Segments/split_into_segments.h>
#include <CGAL/Region_segmentation/Segments/transfer_labels.h>
#include <CGAL/region_segmentation.h>
#include <CGAL/region_segmentation_stages.h>
#ifdef TEST_EIGEN
#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/Region_segmentation/Part_faces/find_common_surfaces.h>
#include <CGAL/Region_segmentation/Part_faces/find_surface_faces.h>
#include <CGAL/Region_segmentation/Segments/close_segments.h>
#include <CGAL/Region_segmentation/Segments/describe_segments.h>
#endif

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <sstream>
#include <vector>

namespace test {

namespace RS = CGAL::Region_segmentation;

struct Visitor
{
  bool on_progress(const char*, double) { return true; }
};

template <typename ConcurrencyTag, typename Mesh>
void use_methods(const Mesh& mesh)
{
  auto segments = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  auto regions = get(CGAL::dynamic_face_property_t<int>(), mesh);
  auto drawn = get(CGAL::dynamic_edge_property_t<std::uint8_t>(), mesh);
  auto seeds = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  for (auto e : edges(mesh))
    put(drawn, e, std::uint8_t(0));
  for (auto f : faces(mesh))
    put(seeds, f, std::size_t(-1));

  Visitor visitor;
  RS::Merge_tree tree;
  RS::segment<ConcurrencyTag>(mesh, segments,
                              RS::parameters::visitor(std::ref(visitor))
                                .edge_is_constrained_map(drawn)
                                .face_seed_map(seeds)
                                .region_map(regions)
                                .merge_tree(tree));
  RS::segment<ConcurrencyTag>(mesh, segments, RS::parameters::method(RS::Visibility_merging()));
  RS::segment<ConcurrencyTag>(mesh, segments,
                              RS::parameters::number_of_segments(2).method(RS::Two_step()));
  const RS::Superfacet_merging below_cost{RS::Visibility_annotator(),
                                          RS::Lowest_cost_first(RS::Visibility_cost()),
                                          RS::Number_below_cost{0}};
  RS::segment<ConcurrencyTag>(mesh, segments, RS::parameters::method(below_cost));
#ifdef TEST_EIGEN
  RS::segment<ConcurrencyTag>(mesh, segments, RS::parameters::method(RS::Smooth_faces()));
#endif

  RS::Segmenter segmenter(mesh, RS::parameters::number_of_segments(2), ConcurrencyTag());
  segmenter.segment(segments);
  segmenter.segment(segments, 3);
  segmenter.add_constraints(drawn);
  segmenter.set_seeds(seeds);
}

template <typename ConcurrencyTag>
void use_polygons()
{
  const std::vector<std::array<double, 3>> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<std::array<std::size_t, 3>> polygons = {
    {0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const std::vector<std::array<std::size_t, 2>> drawn = {{0, 1}};
  std::vector<std::size_t> segments(polygons.size()), seeds(polygons.size());
  RS::segment_polygon_soup<ConcurrencyTag>(
    points, polygons, segments,
    RS::parameters::constrained_edges(drawn).face_seed_map(seeds).component_links(false));
  RS::Polygon_soup_segmenter segmenter(points, polygons, RS::parameters::number_of_segments(2),
                                       ConcurrencyTag());
  segmenter.segment(segments);
  segmenter.segment(segments, 3);
  segmenter.add_constraints(drawn);
  segmenter.set_seeds(seeds);
}

template <typename Mesh>
void use_stages(const Mesh& mesh)
{
  auto features = get(CGAL::dynamic_edge_property_t<std::uint8_t>(), mesh);
  auto regions = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  const RS::Surface surface = RS::make_surface(mesh);
  auto marks = RS::detect_feature_edges(surface, 20, RS::Feature_convexity::ALL);
  std::vector<std::vector<RS::Surface::Index>> lines;
  RS::extract_feature_lines(surface, marks, std::back_inserter(lines));
  RS::write_edge_values(mesh, surface, marks, features);
  const RS::Partition partition = RS::grow_regions(surface,
                                                   RS::edge_values(mesh, surface, features));
  RS::write_face_values(mesh, partition, regions);
  auto graph = RS::build_region_adjacency_graph(surface, partition);
  RS::merge_regions(graph, RS::Smallest_region_first(), 2);
  RS::smooth_borders(mesh, regions);
  RS::write_face_values(mesh, RS::face_values(mesh, regions), regions);
}

template <typename Mesh>
void use_segments(const Mesh& mesh)
{
  auto segments = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  auto others = get(CGAL::dynamic_face_property_t<int>(), mesh);
  auto marks = get(CGAL::dynamic_edge_property_t<std::uint8_t>(), mesh);
  RS::mark_segment_borders(mesh, segments, marks);
  std::vector<RS::Segment_border<Mesh, std::size_t>> borders;
  RS::extract_segment_borders(mesh, segments, std::back_inserter(borders));
  std::vector<RS::Segment_topology<std::size_t>> topologies;
  RS::compute_segment_topology(mesh, segments, std::back_inserter(topologies));
  std::vector<RS::Segment_piece<Mesh, Mesh, std::size_t>> pieces;
  RS::split_into_segments(mesh, segments, std::back_inserter(pieces),
                          RS::parameters::edge_is_constrained_map(marks));
  RS::transfer_labels(mesh, segments, pieces.front().mesh,
                      get(CGAL::dynamic_face_property_t<std::size_t>(), pieces.front().mesh));
  std::vector<typename boost::graph_traits<Mesh>::face_descriptor> nearest;
  RS::find_nearest_faces(mesh, std::vector<std::array<double, 3>>{{0, 0, 0}},
                         std::back_inserter(nearest));
#ifdef TEST_EIGEN
  RS::close_segments(mesh, segments, std::back_inserter(pieces));
  using Point = typename boost::property_map_value<Mesh, CGAL::vertex_point_t>::type;
  using Kernel = typename CGAL::Kernel_traits<Point>::Kernel;
  std::vector<RS::Segment_description<std::size_t, Kernel>> descriptions;
  RS::describe_segments(mesh, segments, std::back_inserter(descriptions));
  const RS::Surface surface = RS::make_surface(mesh);
  const RS::Surface_faces faces = RS::find_surface_faces(surface);
  RS::find_common_surfaces(surface, faces);
  RS::find_common_axes(faces);
#endif

  RS::rand_index_distance(mesh, segments, others);
  RS::consistency_error(mesh, segments, others);
  RS::hamming_distance(mesh, segments, others);
  RS::cut_discrepancy(mesh, segments, others);
  std::stringstream stream;
  RS::IO::write_labels(stream, mesh, segments);
  RS::IO::read_labels(stream, mesh, others);
}

} // namespace test

#endif // CGAL_REGION_SEGMENTATION_TEST_WARNINGS_EVERY_FUNCTION_H
