// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MACHINE_PARTS_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MACHINE_PARTS_H

#include "models/Labelled_model.h"
#include "models/Loft.h"

#include <string>
#include <vector>

namespace segment_mesh {

/// A machine part whose smooth faces are known.
struct Machine_part
{
  std::string name;
  bool has_fillets; ///< whether faces meet tangentially
  Loft loft;
  Tessellation tessellation;

  Labelled_model make() const;
};

/// Twenty without and twenty with fillets. Half of each are tessellated as modellers do it, by long
/// triangles from edge to edge with an angle of 5 to 30 degrees between them, the others by
/// triangles of about one length.
const std::vector<Machine_part>& machine_parts();

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MACHINE_PARTS_H
