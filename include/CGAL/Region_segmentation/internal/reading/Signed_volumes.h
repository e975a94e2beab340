// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_READING_SIGNED_VOLUMES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_READING_SIGNED_VOLUMES_H

#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/support/Large_array.h>
#include <CGAL/Region_segmentation/internal/support/blocks.h>

#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The sum of the signed volumes between the origin and the faces of a mesh, of a body if the surface is closed: by block, so
/// that it has the same bits in parallel.
///
/// Bytes: 8 per block.
class Volume_sum
{
public:
  explicit Volume_sum(std::size_t number_of_faces) : m_volumes(number_of_blocks(number_of_faces)) {}

  /// For the faces of each block in order; `signed_volume`: times 3
  void add(std::size_t face, double signed_volume) { m_volumes[face / block_size] += signed_volume; }

  double sum() const { return std::accumulate(m_volumes.begin(), m_volumes.end(), 0.0) / 3; }

private:
  std::vector<double> m_volumes; // by block, times 3
};

/// The signed volumes between the origin and the faces of a mesh: they tell which closed components are inside out, those
/// whose sum is below 0.
///
/// Bytes: 8 per face, and 12 per face while components are found.
class Signed_volumes
{
  using Index = Flat_mesh::Index;

public:
  explicit Signed_volumes(std::size_t number_of_faces) : m_volumes(number_of_faces) {}

  /// `signed_volume`: times 3
  void set(std::size_t face, double signed_volume) { m_volumes[face] = signed_volume; }

  /// Marks a face at a border: the volume of its component is not a number.
  void set_open(std::size_t face) { m_volumes[face] = std::numeric_limits<double>::quiet_NaN(); }

  double sum() const
  {
    Volume_sum sum(m_volumes.size());
    for (std::size_t f = 0; f < m_volumes.size(); ++f)
      sum.add(f, m_volumes[f]);
    return sum.sum();
  }

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
