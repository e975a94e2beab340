// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_ORIENT_FACES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_ORIENT_FACES_H

#include <CGAL/Region_segmentation/internal/surface/match_sides.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Reverses the boundary of a face, which still begins at its vertex of lowest index.
inline void turn_face(Raw_surface& raw, std::size_t face)
{
  Surface_arrays& arrays = arrays_of(raw.surface);
  const auto first = std::ptrdiff_t(arrays.first_corners[face]),
             past = std::ptrdiff_t(arrays.first_corners[face + 1]);
  arrays.normals[face] = -1.0 * arrays.normals[face];
  std::reverse(arrays.corners.begin() + first + 1, arrays.corners.begin() + past);
  for (auto* sides : {&raw.neighbors, &arrays.adjacencies})
    if (!sides->empty())
      std::reverse(sides->begin() + first, sides->begin() + past);
}

/// Turns faces so that neighbors across edges run in opposite directions along them. Of each
/// component the part of larger area (of equal ones that with the lowest face) remains as it is.
/// Edges whose two faces cannot be oriented consistently become seams.
inline void orient_faces(Raw_surface& raw, const std::vector<Surface::Index>& parallel_sides,
                         std::vector<Seam>& seams)
{
  using Index = Surface::Index;
  Surface_arrays& arrays = arrays_of(raw.surface);
  const std::size_t size = arrays.normals.size();
  if (parallel_sides.empty())
    return;
  std::vector<bool> is_parallel(arrays.corners.size()), is_reached(size), is_turned(size);
  for (const Index side : parallel_sides)
    is_parallel[side] = true;

  for (Index seed = 0; seed < size; ++seed) {
    if (is_reached[seed])
      continue;
    std::vector<Index> component{seed};
    double areas[2] = {0, 0}; // of the faces that are not turned, and of those that are
    is_reached[seed] = true;
    for (std::size_t i = 0; i < component.size(); ++i) {
      const Index f = component[i];
      areas[is_turned[f]] += arrays.areas[f];
      for (Index c = arrays.first_corners[f]; c < arrays.first_corners[f + 1]; ++c)
        if (const Index g = raw.neighbors[c]; Raw_surface::is_face(g) && !is_reached[g]) {
          is_reached[g] = true;
          is_turned[g] = is_turned[f] != is_parallel[c];
          component.push_back(g);
        }
    }
    if (areas[1] > areas[0])
      for (const Index f : component)
        is_turned[f] = !is_turned[f];
  }
  for (Index f = 0; f < size; ++f)
    for (Index c = arrays.first_corners[f]; c < arrays.first_corners[f + 1]; ++c) {
      const Index g = raw.neighbors[c];
      if (!Raw_surface::is_face(g) || g <= f || (is_turned[f] != is_turned[g]) == is_parallel[c])
        continue;
      const Side_of_edge a = side_at(arrays, f, c);
      raw.neighbors[side_across(raw, f, c)] = Raw_surface::at_seam;
      raw.neighbors[c] = Raw_surface::at_seam;
      seams.push_back({a.lower_vertex, a.higher_vertex, f, g, 1});
    }
  for (Index f = 0; f < size; ++f)
    if (is_turned[f])
      turn_face(raw, f);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_ORIENT_FACES_H
