// SPDX-License-Identifier: GPL-3.0-or-later

#include "subdivided_by_loop.h"

#include "cgal_methods.h"
#include "run_on_mesh.h"

#include <CGAL/subdivision_method_3.h>

namespace speed_benchmark {

Triangles subdivided_by_loop(const Triangles& coarse)
{
  Surface_mesh mesh;
  fill_mesh(coarse, mesh, [](Surface_mesh& m, const Triangles::Point& p) {
    return m.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  });
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(1));
  Triangles result;
  for (const auto v : mesh.vertices())
    result.points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    result.corners.push_back({std::uint32_t(mesh.source(h)), std::uint32_t(mesh.target(h)),
                              std::uint32_t(mesh.target(mesh.next(h)))});
  }
  return result;
}

} // namespace speed_benchmark
