// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/make_surface_mesh.h"
#include "segmentation/run_on_mesh.h"

namespace segment_mesh {

Segmentation run_on_surface_mesh(const Polygon_soup& soup, const Corner_links& links, const Marks& marks,
                                 const Segmentation_settings& settings, const Progress_listener& listener)
{
  return run_on_mesh(make_surface_mesh(soup, links), marks, settings, listener);
}

} // namespace segment_mesh
