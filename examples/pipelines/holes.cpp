// SPDX-License-Identifier: GPL-3.0-or-later
//
// The holes of a machine part: a table of their radii and axes. Holes with equal numbers of axes
// are stages of one hole, or opposite each other.

#include "input_mesh.h"

#include <CGAL/Region_segmentation/find_common_surfaces.h>
#include <CGAL/Region_segmentation/make_surface.h>

namespace RS = CGAL::Region_segmentation;

int main(int argc, char** argv)
{
  const RS::Surface surface = RS::make_surface(input_part(argc, argv));
  const RS::Surface_faces faces = RS::find_surface_faces(surface);
  const auto axes = RS::find_common_axes(faces);
  bool is_valid = true;
  std::cout << "face  axis  radius  depth  direction\n";
  for (std::size_t i = 0; i < faces.surfaces.size(); ++i) {
    const RS::Fitted_surface& s = faces.surfaces[i];
    if (faces.roles[i] != RS::Face_role::HOLE || s.kind != RS::Surface_kind::CYLINDER)
      continue;
    const double unit = surface.unit(); // 1, unless the mesh is very large or small
    std::cout << i << "  " << axes[i] << "  " << unit * s.radius << "  "
              << unit * (s.highest - s.lowest) << "  " << s.direction.x << " " << s.direction.y
              << " " << s.direction.z << '\n';
    is_valid = is_valid && s.radius > 0 && s.highest > s.lowest;
  }
  return is_valid ? EXIT_SUCCESS : EXIT_FAILURE;
}
