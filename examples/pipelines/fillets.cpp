// SPDX-License-Identifier: GPL-3.0-or-later
//
// The selection of all fillets of a machine part below a radius, the second argument.

#include "../example_mesh.h"

#include <CGAL/Region_segmentation/Part_faces/find_surface_faces.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <limits>
#include <set>

namespace RS = CGAL::Region_segmentation;

/// Of the ball that rolls along a fillet; infinite for faces that are none.
double fillet_radius(const RS::Fitted_surface<>& s, RS::Face_role role)
{
  if (role != RS::Face_role::BLEND || s.kind == RS::Surface_kind::FREEFORM)
    return std::numeric_limits<double>::infinity();
  return s.kind == RS::Surface_kind::TORUS ? s.minor_radius : s.radius;
}

int main(int argc, char** argv)
{
  Mesh mesh = read_mesh(argc, argv, "flange.off");
  const double limit = argc > 2 ? std::stod(argv[2]) : 7;
  auto is_selected = mesh.add_property_map<Mesh::Face_index, bool>("f:is_fillet", false).first;
  const RS::Surface surface = RS::make_surface(mesh);
  const RS::Surface_faces faces = RS::find_surface_faces(surface);
  std::set<std::size_t> fillets;
  std::size_t f = 0; // the faces of a surface are numbered as those of the mesh are iterated
  for (const auto face : mesh.faces()) {
    const std::size_t i = faces.partition[f++];
    is_selected[face] = surface.unit() * fillet_radius(faces.surfaces[i], faces.roles[i]) < limit;
    if (is_selected[face])
      fillets.insert(i);
  }
  std::cout << fillets.size() << " fillets with radii below " << limit << '\n';
  write_colored(mesh, is_selected, "fillets.ply");
}
