// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/run_on_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

namespace segment_mesh {

Segmentation run_on_surface_mesh(const Polygon_soup& soup, const Segmentation_settings& settings,
                                 const Progress_listener& listener)
{
  CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  return run_on_mesh(mesh, settings, listener);
}

} // namespace segment_mesh
