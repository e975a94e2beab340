// SPDX-License-Identifier: GPL-3.0-or-later
//
// The smooth faces of a machine part, and the primitive that fits each best.

#include "input_mesh.h"

#include <CGAL/Region_segmentation/Methods/Smooth_faces.h>
#include <CGAL/Region_segmentation/Segments/describe_segments.h>
#include <CGAL/Region_segmentation/segment.h>

#include <iterator>
#include <vector>

namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = input_mesh(argc, argv);
  auto face_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:smooth_face").first;
  RS::segment(mesh, face_id, RS::parameters::method(RS::Smooth_faces()));

  std::vector<RS::Segment_description<std::size_t, Kernel>> descriptions;
  const std::size_t n = RS::describe_segments(mesh, face_id, std::back_inserter(descriptions));
  const char* const names[] = {"plane", "sphere", "cylinder", "cone"};
  bool is_best = true;
  for (const auto& d : descriptions) {
    const RS::Fitted_primitive<Kernel>& p = d.primitive;
    std::cout << "face " << d.segment << ": area " << d.area << ", " << d.neighbors.size()
              << " neighbors, " << names[int(p.type)] << ", radius " << p.radius << ", error "
              << p.error << '\n';
    is_best = is_best && p.error <= p.error_of(RS::Primitive_type::PLANE);
  }
  return n > 0 && is_best ? EXIT_SUCCESS : EXIT_FAILURE;
}
