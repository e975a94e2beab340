// SPDX-License-Identifier: GPL-3.0-or-later

#include "run_on_mesh.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

namespace speed_benchmark {

namespace {

using Polyhedron = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;

auto add_point(Polyhedron& mesh, const Triangles::Point& p)
{
  const auto v = add_vertex(mesh);
  v->point() = Kernel::Point_3(p[0], p[1], p[2]);
  return v;
}

class On_polyhedron : public Mesh_subject<Polyhedron>
{
public:
  explicit On_polyhedron(const Triangles& triangles)
    : Mesh_subject(triangles, add_point)
  {
    CGAL::set_halfedgeds_items_id(m_mesh);
  }
};

} // namespace

std::unique_ptr<Subject> make_polyhedron_subject(const Triangles& triangles)
{
  return std::make_unique<On_polyhedron>(triangles);
}

} // namespace speed_benchmark
