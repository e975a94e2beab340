// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/run_on_mesh.h"
#include "soup/link_corners.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/boost/graph/helpers.h>

namespace segment_mesh {

Segmentation run_on_polyhedron(const Polygon_soup& soup, const Marks& marks,
                               const Segmentation_settings& settings,
                               const Progress_listener& listener)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;
  if (!is_oriented_manifold(soup))
    throw Not_a_manifold();
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  CGAL::set_halfedgeds_items_id(mesh);
  return run_on_mesh(mesh, marks, settings, listener);
}

} // namespace segment_mesh
