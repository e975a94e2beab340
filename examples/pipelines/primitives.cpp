// SPDX-License-Identifier: GPL-3.0-or-later
//
// The smooth faces of a machine part, and the simple surface that fits each best.

#include "../example_mesh.h"

#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/Region_segmentation/Segments/describe_segments.h>
#include <CGAL/Region_segmentation/segment.h>

#include <iterator>
#include <vector>

namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv, "flange.off");
  auto face_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:smooth_face").first;
  RS::segment(mesh, face_id, RS::parameters::method(RS::Smooth_faces()));

  std::vector<RS::Segment_description<std::size_t, Kernel>> descriptions;
  RS::describe_segments(mesh, face_id, std::back_inserter(descriptions));
  const char* const names[] = {"plane", "cylinder", "cone", "sphere"};
  for (const auto& d : descriptions) {
    const RS::Fitted_surface<Kernel>& s = d.surface;
    std::cout << "face " << d.segment << ": area " << d.area << ", " << d.neighbors.size()
              << " neighbors, " << names[int(s.kind)] << ", radius " << s.radius << ", error "
              << d.surface_error() << '\n';
  }
  for (auto f : faces(mesh)) // colors of kinds
    face_id[f] = std::size_t(descriptions[face_id[f]].surface.kind);
  write_colored(mesh, face_id, "primitives.ply");
}
