// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_SIGNED_VOLUMES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_SIGNED_VOLUMES_H

#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>

#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The signed volumes between the origin and the faces of a mesh: they tell which closed components are inside out, those
/// whose sum is below 0.
///
/// Bytes: 8 per face, and 12 per face while components are found.
class Signed_volumes
{
  using Index = Flat_mesh::Index;

public:
  explicit Signed_volumes(std::size_t number_of_faces) : m_volumes(number_of_faces) {}

  /// `point`: a corner of the face
  void set(std::size_t face, const Double_3& point, const Double_3& area_vector)
  {
    m_volumes[face] = dot(point, area_vector);
  }

  /// Marks a face at a border: the volume of its component is not a number.
  void set_open(std::size_t face) { m_volumes[face] = std::numeric_limits<double>::quiet_NaN(); }

  /// Of all faces: of the body, if the surface is closed.
  double sum() const { return std::accumulate(m_volumes.begin(), m_volumes.end(), 0.0) / 3; }

  /// The faces of the closed components that are inside out, in order; `component`: of each face.
  std::vector<Index> faces_inside_out(const Partition& component) const
  {
    std::vector<double> volumes(component.number_of_parts());
    for (std::size_t f = 0; f < component.size(); ++f)
      volumes[component[f]] += m_volumes[f];
    std::vector<Index> faces;
    for (std::size_t f = 0; f < component.size(); ++f)
      if (volumes[component[f]] < 0)
        faces.push_back(Index(f));
    return faces;
  }

private:
  Large_array<double> m_volumes; // by face, times 3
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_READING_SIGNED_VOLUMES_H
