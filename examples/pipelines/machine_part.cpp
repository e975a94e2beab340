// SPDX-License-Identifier: GPL-3.0-or-later
//
// The borders of the smooth faces of a machine part, as polylines: the features that domains of
// CGAL's Mesh_3 take.

#include "../example_mesh.h"

#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/Region_segmentation/Segments/segment_borders.h>
#include <CGAL/Region_segmentation/segment.h>

#include <fstream>
#include <iterator>
#include <vector>

namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv, "flange.off");
  auto face_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:smooth_face").first;
  const std::size_t n = RS::segment(mesh, face_id, RS::parameters::method(RS::Smooth_faces()));
  std::vector<RS::Segment_border<Mesh, std::size_t>> borders;
  RS::extract_segment_borders(mesh, face_id, std::back_inserter(borders));

  std::ofstream features("machine_part.polylines.txt");
  for (const auto& border : borders) {
    features << border.halfedges.size() + 1 << ' '
             << mesh.point(source(border.halfedges.front(), mesh));
    for (auto h : border.halfedges)
      features << ' ' << mesh.point(target(h, mesh));
    features << '\n';
  }
  std::cout << n << " smooth faces, " << borders.size() << " features\n";
  write_colored(mesh, face_id, "machine_part.ply");
}
