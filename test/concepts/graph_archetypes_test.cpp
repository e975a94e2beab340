// SPDX-License-Identifier: GPL-3.0-or-later

// Every function that takes a face graph, on models of the concepts that it names alone.

#include "concepts/Face_graph_archetype.h"
#include "stages.h"

#include <CGAL/Region_segmentation/Evaluation/evaluation.h>
#include <CGAL/Region_segmentation/Evaluation/labels.h>
#include <CGAL/Region_segmentation/Part_faces/find_part_faces.h>
#include <CGAL/Region_segmentation/Segments/close_segments.h>
#include <CGAL/Region_segmentation/Segments/compute_segment_topology.h>
#include <CGAL/Region_segmentation/Segments/describe_segments.h>
#include <CGAL/Region_segmentation/Segments/find_nearest_faces.h>
#include <CGAL/Region_segmentation/Segments/segment_borders.h>
#include <CGAL/Region_segmentation/Segments/split_into_segments.h>
#include <CGAL/Region_segmentation/Segments/transfer_labels.h>
#include <CGAL/region_segmentation.h>
#include <CGAL/region_segmentation_stages.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>
#include <vector>

namespace graph_archetypes_test {

namespace RS = CGAL::Region_segmentation;
using graph_archetypes::Edge;
using graph_archetypes::Face;
using graph_archetypes::Graph;
using graph_archetypes::Graph_with_edges;
using graph_archetypes::Halfedge;
using graph_archetypes::Index_map;
using graph_archetypes::Mesh;
using graph_archetypes::Values;
using graph_archetypes::Vertex;

template <typename G>
struct Archetypes
{
  test::Surface_mesh mesh = test::to_surface_mesh(test::triangulated(test::dumbbell()));
  G graph{mesh};
  Values<Face, std::size_t> segments{num_faces(mesh)}, others{num_faces(mesh)};
  Values<Edge, bool> marks{num_edges(mesh)};

  /// Maps that a mesh without internal ones has to be given.
  auto maps() const
  {
    return RS::parameters::vertex_index_map(Index_map<Vertex>()).face_index_map(Index_map<Face>());
  }
};

TEST(Graph_archetypes_test, of_faces_halfedges_and_vertices)
{
  Archetypes<Graph> a;
  const std::size_t number_of_faces = num_faces(a.mesh);
  EXPECT_EQ(RS::segment(a.graph, a.segments, a.maps().number_of_segments(3)), 3u);
  const RS::Segmenter segmenter(a.graph,
                                a.maps().face_seed_map(Values<Face, int>(number_of_faces, -1)));
  EXPECT_EQ(segmenter.segment(a.segments, 3), 3u);
  EXPECT_EQ(RS::make_surface(a.graph, a.maps()).number_of_faces(), number_of_faces);
  EXPECT_GT(test::detect_feature_edges(a.graph, a.marks, test::Feature_options(), a.maps()), 0u);
  EXPECT_EQ(test::grow_regions(a.graph, a.marks, a.others, a.maps()), 3u);
  EXPECT_EQ(test::build_region_adjacency_graph(a.graph, a.segments, a.maps()).number_of_regions(),
            3u);
  RS::smooth_borders(a.graph, a.others, {}, a.maps());
  EXPECT_EQ(RS::face_values(a.graph, a.segments).size(), number_of_faces);

  using Label = std::size_t;
  using Piece = RS::Segment_piece<Mesh, Graph, Label>;
  const auto maps = a.maps().halfedge_index_map(Index_map<Halfedge>());
  std::vector<RS::Segment_border<Graph, Label>> borders;
  RS::extract_segment_borders(a.graph, a.segments, std::back_inserter(borders), maps);
  EXPECT_EQ(borders.size(), 2u);
  std::vector<RS::Segment_topology<Label>> topologies;
  RS::compute_segment_topology(a.graph, a.segments, std::back_inserter(topologies), maps);
  EXPECT_EQ(topologies.size(), 3u);
  std::vector<Piece> pieces;
  const auto output = RS::split_into_segments<Mesh>(a.graph, a.segments, std::back_inserter(pieces),
                                                    maps);
  RS::close_segments<Mesh>(a.graph, a.segments, output, maps);
  EXPECT_EQ(pieces.size(), 6u);
  EXPECT_EQ(RS::transfer_labels(a.graph, a.segments, a.graph, a.others, maps, maps), 3u);
  std::vector<Face> nearest;
  const std::vector<std::array<double, 3>> points = {{0, 0, 0}};
  RS::find_nearest_faces(a.graph, points, std::back_inserter(nearest), a.maps());
  EXPECT_EQ(nearest.size(), 1u);
  using Kernel = CGAL::Kernel_traits<Mesh::Point>::Kernel;
  std::vector<RS::Segment_description<Label, Kernel>> descriptions;
  RS::describe_segments(a.graph, a.segments, std::back_inserter(descriptions), maps);
  EXPECT_EQ(descriptions.size(), 3u);
  std::vector<RS::Part_face<Kernel>> part_faces;
  EXPECT_GT(RS::find_part_faces(a.graph, a.others, std::back_inserter(part_faces), a.maps()), 3u);

  EXPECT_GT(RS::rand_index_distance(a.graph, a.segments, a.others), 0);
  EXPECT_GT(RS::hamming_distance(a.graph, a.segments, a.others, a.maps()).distance, 0);
  EXPECT_EQ(RS::consistency_error(a.graph, a.segments, a.others, a.maps()).local, 0);
  EXPECT_EQ(RS::cut_discrepancy(a.graph, a.segments, a.segments, a.maps()).value(), 0);
  std::stringstream stream;
  EXPECT_TRUE(RS::IO::write_labels(stream, a.graph, a.segments));
  RS::IO::read_labels(stream, a.graph, a.others);
  EXPECT_EQ(*a.others.values, *a.segments.values);
}

TEST(Graph_archetypes_test, of_edges_where_edge_maps_are_read_or_written)
{
  Archetypes<Graph_with_edges> a;
  EXPECT_GT(test::detect_feature_edges(a.graph, a.marks, test::Feature_options(), a.maps()), 0u);
  const auto with_marks = a.maps().edge_is_constrained_map(a.marks);
  EXPECT_EQ(RS::segment(a.graph, a.segments, with_marks.number_of_segments(1)), 3u);
  RS::Segmenter segmenter(a.graph, with_marks);
  segmenter.add_constraints(a.marks, a.maps());
  EXPECT_EQ(segmenter.segment(a.segments, 1), 3u);
  RS::smooth_borders(a.graph, a.segments, {}, with_marks);
  EXPECT_EQ(test::build_region_adjacency_graph(a.graph, a.segments, with_marks).number_of_regions(),
            3u);
  std::vector<std::vector<Vertex>> lines;
  test::extract_feature_lines(a.graph, a.marks, std::back_inserter(lines), std::size_t(-1),
                              a.maps());
  EXPECT_FALSE(lines.empty());
  EXPECT_GT(RS::mark_segment_borders(a.graph, a.segments, a.marks), 0u);
}

} // namespace graph_archetypes_test
