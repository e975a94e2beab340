// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/run_on_mesh.h"
#include "soup/link_corners.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/boost/graph/helpers.h>

#include <vector>

namespace segment_mesh {

Segmentation run_on_polyhedron(const Polygon_soup& soup, const Marks& marks, const Segmentation_settings& settings,
                               const Progress_listener& listener)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;
  if (!is_oriented_manifold(soup))
    throw Not_a_manifold();
  Mesh mesh; // made here, since CGAL's function leaves out points that no face uses
  std::vector<boost::graph_traits<Mesh>::vertex_descriptor> vertices, corners;
  for (const Point& p : soup.points) {
    vertices.push_back(add_vertex(mesh));
    vertices.back()->point() = {p[0], p[1], p[2]};
  }
  for (const Polygon_soup::Polygon& polygon : soup.polygons) {
    corners.clear();
    for (std::size_t i : polygon)
      corners.push_back(vertices[i]);
    CGAL::Euler::add_face(corners, mesh);
  }
  CGAL::set_halfedgeds_items_id(mesh);
  return run_on_mesh(mesh, marks, settings, listener);
}

} // namespace segment_mesh
