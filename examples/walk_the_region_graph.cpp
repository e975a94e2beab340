// SPDX-License-Identifier: GPL-3.0-or-later
//
// The region graph is a graph of Boost.Graph: here, how many borders are between each segment and
// the first one.

#include "example_mesh.h"

#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Surface/face_values.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/region_segmentation.h>

#include <boost/graph/breadth_first_search.hpp>

#include <vector>

namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  RS::segment(mesh, segment_id);
  const auto segments = RS::Partition::from_labels(RS::face_values(mesh, segment_id));
  const auto graph = RS::build_region_adjacency_graph(RS::make_surface(mesh), segments);

  std::vector<int> distance(num_vertices(graph), 0);
  auto record = boost::record_distances(distance.data(), boost::on_tree_edge());
  boost::breadth_first_search(graph, 0, boost::visitor(boost::make_bfs_visitor(record)));

  for (auto r : CGAL::make_range(vertices(graph)))
    std::cout << "segment " << r << ": area " << graph[r].area << ", " << distance[r]
              << " borders from segment 0\n";
  for (auto f : faces(mesh))
    segment_id[f] = std::size_t(distance[segment_id[f]]);
  write_colored(mesh, segment_id, "walk_the_region_graph.ply");
}
