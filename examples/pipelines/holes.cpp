// SPDX-License-Identifier: GPL-3.0-or-later
//
// The holes and the fillets of a machine part: a table of their radii, and of the axes of holes.
// Holes with equal numbers of axes are stages of one hole, or opposite each other.

#include "../example_mesh.h"

#include <CGAL/Region_segmentation/Part_faces/find_part_faces.h>

#include <iterator>
#include <vector>

namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv, "flange.off");
  auto face_id = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part_face").first;
  std::vector<RS::Part_face<Kernel>> faces;
  RS::find_part_faces(mesh, face_id, std::back_inserter(faces));
  std::cout << "holes: face  axis  radius  depth  direction\n";
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const RS::Part_face<Kernel>& f = faces[i];
    const RS::Fitted_surface<Kernel>& s = f.surface;
    if (f.role == RS::Face_role::HOLE && s.kind == RS::Surface_kind::CYLINDER)
      std::cout << i << "  " << f.first_on_axis << "  " << s.radius << "  " << s.highest - s.lowest
                << "  " << s.direction << '\n';
  }
  std::cout << "fillets: face  radius\n"; // that of the ball that rolls along it
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (const RS::Fitted_surface<Kernel>& s = faces[i].surface;
        faces[i].role == RS::Face_role::BLEND && s.kind != RS::Surface_kind::FREEFORM)
      std::cout << i << "  " << (s.kind == RS::Surface_kind::TORUS ? s.minor_radius : s.radius)
                << '\n';
  write_colored(mesh, face_id, "holes.ply");
}
