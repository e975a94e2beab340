// SPDX-License-Identifier: GPL-3.0-or-later
//
// The region graph is a graph of Boost.Graph: here, which regions are how far from the first one.

#include "dumbbell.h"

#include <CGAL/region_segmentation_stages.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/breadth_first_search.hpp>

#include <iostream>
#include <vector>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace RS = CGAL::Region_segmentation;

int main()
{
  Mesh mesh = make_dumbbell<Mesh, Point>();
  auto region_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:region").first;
  auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature").first;
  RS::detect_feature_edges(mesh, is_feature, RS::parameters::maximum_angle(5.0));
  RS::grow_regions(mesh, is_feature, region_id);
  const auto graph = RS::build_region_adjacency_graph(mesh, region_id);

  std::vector<int> distance(num_vertices(graph), 0);
  auto record = boost::record_distances(distance.data(), boost::on_tree_edge());
  boost::breadth_first_search(graph, 0, boost::visitor(boost::make_bfs_visitor(record)));

  for (auto r : CGAL::make_range(vertices(graph)))
    std::cout << "region " << r << ": area " << graph[r].area << ", " << distance[r]
              << " borders from region 0\n";
}
