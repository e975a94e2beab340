// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MACHINE_PART_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MACHINE_PART_H

#include "segmentation/Segmentation_details.h"

#include <CGAL/Region_segmentation/Part_faces/find_surface_faces.h>
#include <CGAL/Region_segmentation/Surface.h>

#include <cstddef>
#include <map>
#include <vector>

namespace segment_mesh {

/// A mesh with its faces as the method smooth-faces finds them. Labels are of the faces of the
/// mesh.
class Machine_part
{
public:
  /// `tolerance`: that of the method, in units of the mesh; 0: found from the mesh
  Machine_part(CGAL::Region_segmentation::Surface surface, double tolerance);

  /// Of each label that is of one face, or of a piece of it, alone.
  std::map<std::size_t, Surface_face> faces(const std::vector<std::size_t>& labels) const;

  /// The labels that each label meets smoothly. \pre labels are numbered from 0 to n - 1
  std::vector<std::vector<std::size_t>> smooth_neighbors(const std::vector<std::size_t>& labels,
                                                         std::size_t n) const;

private:
  CGAL::Region_segmentation::Surface m_surface;
  CGAL::Region_segmentation::Surface_faces m_faces;
  std::vector<CGAL::Region_segmentation::Partition::Index> m_common_surfaces, m_common_axes;
};

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MACHINE_PART_H
