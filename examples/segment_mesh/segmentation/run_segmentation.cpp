// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/run_segmentation.h"

namespace segment_mesh {

Segmentation run_segmentation(const Polygon_soup& soup, const Segmentation_settings& settings,
                              const Progress_listener& listener)
{
  switch (settings.mesh_type) {
  case Mesh_type::SURFACE_MESH:
    return run_on_surface_mesh(soup, settings, listener);
  case Mesh_type::POLYHEDRON:
    return run_on_polyhedron(soup, settings, listener);
  case Mesh_type::OPENMESH:
    return run_on_openmesh(soup, settings, listener);
  }
  return {};
}

} // namespace segment_mesh
