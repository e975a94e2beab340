// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/make_surface_mesh.h"
#include "segmentation/run_on_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <optional>

namespace segment_mesh {

Segmentation run_on_surface_mesh(const Polygon_soup& soup, const Marks& marks,
                                 const Segmentation_settings& settings,
                                 const Progress_listener& listener)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
  const std::optional<Corner_links> links = link_corners(soup);
  if (!links)
    throw Not_a_manifold();
  return run_on_mesh(make_surface_mesh<Mesh>(soup, *links), marks, settings, listener);
}

} // namespace segment_mesh
