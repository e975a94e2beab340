// SPDX-License-Identifier: GPL-3.0-or-later
//
// What segment() with the method Two_step does, stage by stage; each stage can be used alone.

#include "dumbbell.h"

#include <CGAL/Region_segmentation/Methods/Two_step.h>
#include <CGAL/region_segmentation_stages.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>
#include <iterator>
#include <vector>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
namespace RS = CGAL::Region_segmentation;

int main()
{
  Mesh mesh = make_dumbbell<Mesh, Point>();
  auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature").first;
  auto region_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:region").first;

  // Stage 1: the edges with an angle of more than 5 degrees between their faces, in valleys.
  std::cout << RS::detect_feature_edges(mesh, is_feature, RS::parameters::maximum_angle(5.0))
            << " feature edges\n";
  std::vector<std::vector<Mesh::Vertex_index>> lines;
  RS::extract_feature_lines(mesh, is_feature, std::back_inserter(lines));
  for (const auto& line : lines)
    std::cout << "a feature line of " << line.size() - 1 << " edges, "
              << (line.front() == line.back() ? "closed\n" : "open\n");

  // Stage 2: what lies between them.
  std::cout << RS::grow_regions(mesh, is_feature, region_id) << " regions\n";

  // Stage 3: merging. The graph knows no mesh.
  auto graph = RS::build_region_adjacency_graph(mesh, region_id);
  for (auto s : CGAL::make_range(edges(graph)))
    std::cout << "regions " << source(s, graph) << " and " << target(s, graph) << " share "
              << graph[s].length << ", mean dihedral angle " << graph[s].mean_angle() << " rad\n";
  const RS::Policy_phases<RS::Smallest_region_first, RS::Least_compact_region_first> steps{
    {RS::Smallest_region_first(), 4}, {RS::Least_compact_region_first(), 2}};
  const RS::Merge_tree tree = RS::merge_regions(graph, steps, 2);
  for (const auto& merge : tree.merges())
    std::cout << "region " << merge.removed << " was merged into " << merge.kept << '\n';
}
