// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/Manifold.h"

namespace segment_mesh {

Manifold make_manifold(const Polygon_soup& soup)
{
  return {make_manifold_of<Manifold::Mesh>(soup)};
}

} // namespace segment_mesh
