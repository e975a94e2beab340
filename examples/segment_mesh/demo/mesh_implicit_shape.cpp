// SPDX-License-Identifier: GPL-3.0-or-later

#include "demo/Implicit_shape.h"
#include "demo/Time_stamped.h"

#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/IO/facets_in_complex_2_to_triangle_mesh.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/make_surface_mesh.h>

namespace segment_mesh {

namespace {

// CGAL::Surface_mesh_default_triangulation_3, but for the time stamps.
using Mesh_traits =
  CGAL::Robust_circumcenter_traits_3<CGAL::Exact_predicates_inexact_constructions_kernel>;
using Vertex_base = Time_stamped<CGAL::Surface_mesh_vertex_base_3<Mesh_traits>>;
using Cell_base = Time_stamped<CGAL::Delaunay_triangulation_cell_base_with_circumcenter_3<
  Mesh_traits, CGAL::Surface_mesh_cell_base_3<Mesh_traits>>>;
using Triangulation =
  CGAL::Delaunay_triangulation_3<Mesh_traits,
                                 CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base>>;
using Mesh = CGAL::Surface_mesh<Mesh_traits::Point_3>;

Point to_point(const Mesh_traits::Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}

/// CGAL's mesher draws its first points from the default generator, which starts from the time.
class Fixed_default_random
{
public:
  Fixed_default_random() { CGAL::get_default_random() = CGAL::Random(0); }
  ~Fixed_default_random() { CGAL::get_default_random() = m_before; }
  Fixed_default_random(const Fixed_default_random&) = delete;
  Fixed_default_random& operator=(const Fixed_default_random&) = delete;

private:
  CGAL::Random m_before = CGAL::get_default_random();
};

} // namespace

Polygon_soup mesh_implicit_shape(const Implicit_shape& shape, const Ball& bounds,
                                 double edge_length)
{
  const Fixed_default_random fixed;
  const auto function = [&shape](const Mesh_traits::Point_3& p) { return shape(to_point(p)); };
  const Mesh_traits::Sphere_3 sphere(
    Mesh_traits::Point_3(bounds.center[0], bounds.center[1], bounds.center[2]),
    bounds.radius * bounds.radius);
  const double relative_precision = 1e-4;
  const CGAL::Implicit_surface_3<Mesh_traits, decltype(function)> surface(function, sphere,
                                                                          relative_precision);
  const double least_angle_in_degrees = 30, chord_error = edge_length / 3;
  const CGAL::Surface_mesh_default_criteria_3<Triangulation> criteria(least_angle_in_degrees,
                                                                      edge_length, chord_error);
  // Enough first points that some lie on each of a dozen parts.
  const int number_of_first_points = 60;
  Triangulation triangulation;
  CGAL::Complex_2_in_triangulation_3<Triangulation> complex(triangulation);
  CGAL::make_surface_mesh(complex, surface, criteria, CGAL::Manifold_tag(), number_of_first_points);
  Mesh mesh;
  CGAL::facets_in_complex_2_to_triangle_mesh(complex, mesh);

  Polygon_soup soup;
  for (const Mesh::Vertex_index v : mesh.vertices())
    soup.points.push_back(to_point(mesh.point(v)));
  for (const Mesh::Face_index f : mesh.faces()) {
    Polygon_soup::Polygon& triangle = soup.polygons.emplace_back();
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      triangle.push_back(v.idx());
  }
  return soup;
}

} // namespace segment_mesh
