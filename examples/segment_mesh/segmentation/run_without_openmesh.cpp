// SPDX-License-Identifier: GPL-3.0-or-later

// What stands for run_on_openmesh.cpp where OpenMesh is not installed.

#include "segmentation/run_segmentation.h"

#include <stdexcept>

namespace segment_mesh {

Segmentation run_on_openmesh(const Polygon_soup&, const Marks&, const Segmentation_settings&,
                             const Progress_listener&)
{
  throw std::logic_error("this program was built without OpenMesh");
}

bool is_available(Mesh_type type)
{
  return type != Mesh_type::OPENMESH;
}

} // namespace segment_mesh
