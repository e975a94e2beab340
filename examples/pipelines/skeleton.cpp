// SPDX-License-Identifier: GPL-3.0-or-later
//
// A skeleton of a figure from its region graph: from the middle of each part to the middles of its
// borders.

#include "../example_mesh.h"

#include <CGAL/Region_segmentation/Graph/build_region_adjacency_graph.h>
#include <CGAL/Region_segmentation/Segments/segment_borders.h>
#include <CGAL/Region_segmentation/Surface/face_values.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>
#include <CGAL/region_segmentation.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv);
  auto segment_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  const std::size_t n = RS::segment(mesh, segment_id,
                                    RS::parameters::component_links(false)); // joints are edges

  std::vector<std::vector<Point>> points_of_part(n);
  for (auto f : faces(mesh))
    points_of_part[segment_id[f]].push_back(mesh.point(target(halfedge(f, mesh), mesh)));
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Point>> points_of_joint;
  std::vector<RS::Segment_border<Mesh, std::size_t>> borders;
  RS::extract_segment_borders(mesh, segment_id, std::back_inserter(borders));
  for (const auto& border : borders)
    for (auto h : border.halfedges)
      points_of_joint[{border.segment, border.opposite_segment}].push_back(
        mesh.point(target(h, mesh)));
  const auto middle = [](const std::vector<Point>& p) {
    return CGAL::centroid(p.begin(), p.end(), CGAL::Dimension_tag<0>());
  };
  const auto graph = RS::build_region_adjacency_graph(
    RS::make_surface(mesh, RS::parameters::component_links(false)),
    RS::Partition::from_labels(RS::face_values(mesh, segment_id)));
  std::ofstream out("skeleton.polylines.txt");
  for (auto s : CGAL::make_range(edges(graph))) {
    const auto [a, b] = std::minmax<std::size_t>({source(s, graph), target(s, graph)});
    out << "3 " << middle(points_of_part[a]) << ' ' << middle(points_of_joint.at({a, b})) << ' '
        << middle(points_of_part[b]) << '\n';
  }
  std::cout << n << " parts, " << num_edges(graph) << " joints\n";
}
