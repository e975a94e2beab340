// SPDX-License-Identifier: GPL-3.0-or-later
//
// The borders of the smooth faces of a machine part, as polylines: the features that domains of
// CGAL's Mesh_3 take.

#include "input_mesh.h"

#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/Region_segmentation/Segments/segment_borders.h>
#include <CGAL/Region_segmentation/segment.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = input_mesh(argc, argv);
  auto face_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:smooth_face").first;
  auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  const std::size_t n = RS::segment(mesh, face_id, RS::parameters::method(RS::Smooth_faces()));
  CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, 40, is_sharp);

  std::vector<RS::Segment_border<Mesh, std::size_t>> borders;
  RS::extract_segment_borders(mesh, face_id, std::back_inserter(borders));
  std::vector<std::vector<Point>> features;
  std::size_t sharp_edges = 0;
  for (const auto& border : borders) {
    features.push_back({mesh.point(source(border.halfedges.front(), mesh))});
    for (auto h : border.halfedges) {
      features.back().push_back(mesh.point(target(h, mesh)));
      sharp_edges += is_sharp[edge(h, mesh)];
    }
  }
  const auto all = edges(mesh);
  const std::size_t all_sharp = std::size_t(
    std::count_if(all.begin(), all.end(), [&](auto e) { return is_sharp[e]; }));
  std::cout << n << " smooth faces, " << features.size() << " features with " << sharp_edges
            << " of " << all_sharp << " sharp edges\n";
  return 100 * sharp_edges >= 99 * all_sharp ? EXIT_SUCCESS : EXIT_FAILURE;
}
