// SPDX-License-Identifier: GPL-3.0-or-later
//
// What segment() with the method Two_step does, stage by stage; each stage can be used alone.

#include "example_mesh.h"

#include <CGAL/Region_segmentation/Two_step/Two_step.h>
#include <CGAL/region_segmentation_stages.h>

#include <cstdint>
#include <iterator>
#include <vector>

namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv);
  auto is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:feature").first;
  auto region_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:region").first;

  // The stages work on arrays: vertices and faces are numbered as in the mesh.
  const RS::Surface surface = RS::make_surface(mesh);

  // Stage 1: the edges with an angle of more than 5 degrees between their faces, in valleys. Maps
  // of edges are read by edge_values(), and written by write_edge_values().
  std::vector<std::uint8_t> features = RS::detect_feature_edges(surface, 5);
  std::vector<std::vector<RS::Surface::Index>> lines; // of vertices
  RS::extract_feature_lines(surface, features, std::back_inserter(lines));
  std::cout << RS::write_edge_values(mesh, surface, features, is_feature) << " feature edges in "
            << lines.size() << " feature lines\n";

  // Stage 2: what lies between them.
  const RS::Partition regions = RS::grow_regions(surface, features);
  RS::write_face_values(mesh, regions, region_id);
  std::cout << regions.number_of_parts() << " regions\n";

  // Stage 3: merging, here until 10 regions are left. The graph knows no mesh.
  auto graph = RS::build_region_adjacency_graph(surface, regions);
  const RS::Policy_phases<RS::Smallest_region_first, RS::Least_compact_region_first> steps{
    {RS::Smallest_region_first(), 20}, {RS::Least_compact_region_first(), 10}};
  const RS::Merge_tree tree = RS::merge_regions(graph, steps, 10);
  const RS::Partition segment = tree.partition_at_count(10);
  for (auto f : faces(mesh))
    region_id[f] = segment[region_id[f]];
  std::cout << tree.merges().size() << " merges\n";
  write_colored(mesh, region_id, "run_the_stages.ply");
}
