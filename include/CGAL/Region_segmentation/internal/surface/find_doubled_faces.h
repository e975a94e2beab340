// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_DOUBLED_FACES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_DOUBLED_FACES_H

#include <CGAL/Region_segmentation/internal/support/for_each_repetition.h>
#include <CGAL/Region_segmentation/internal/surface/Raw_surface.h>
#include <CGAL/Region_segmentation/internal/surface/Added_adjacency.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Whether two faces have the same vertices in the same cyclic order, or in the reverse one. Each
/// begins at its vertex of lowest index.
inline bool are_equal_faces(const Surface& s, Surface::Index f, Surface::Index g)
{
  const std::size_t n = s.number_of_corners(f);
  if (s.number_of_corners(g) != n)
    return false;
  bool is_same = true, is_reverse = true;
  for (std::size_t i = 0; i < n && (is_same || is_reverse); ++i) {
    is_same = is_same && s.corner(f, i) == s.corner(g, i);
    is_reverse = is_reverse && s.corner(f, i) == s.corner(g, (n - i) % n);
  }
  return is_same || is_reverse;
}

/// A number for the sides of a face, whatever their order and directions.
inline std::size_t key_of_sides(const Surface& s, Surface::Index f)
{
  std::size_t sum = 0;
  for_each_side(s, f, [&](Surface::Index v, Surface::Index w) {
    sum += boost::hash<std::pair<Surface::Index, Surface::Index>>()(std::minmax(v, w));
  });
  return sum;
}

/// Lets the sides of a face lead to itself. Those of its neighbors that led to it are open then.
inline void separate_from_neighbors(Raw_surface& raw, Surface::Index face)
{
  const auto& first_corners = arrays_of(raw.surface).first_corners;
  for (Surface::Index side = first_corners[face]; side < first_corners[face + 1]; ++side) {
    const Surface::Index neighbor = raw.neighbors[side];
    raw.neighbors[side] = face;
    if (!Raw_surface::is_face(neighbor) || neighbor == face)
      continue;
    for (Surface::Index s = first_corners[neighbor]; s < first_corners[neighbor + 1]; ++s)
      if (raw.neighbors[s] == face)
        raw.neighbors[s] = Raw_surface::none;
  }
}

/// Makes faces degenerate that were given before, in any orientation, and gives them an adjacency
/// to the first of their kind alone. Only faces with open sides are looked at. O(n log n) for n of
/// them.
inline void find_doubled_faces(Raw_surface& raw, std::vector<Added_adjacency>& added)
{
  using Index = Surface::Index;
  Surface_arrays& arrays = arrays_of(raw.surface);
  const std::vector<Index> faces = faces_with_open_sides(raw);
  for_each_repetition(
    faces.size(),
    [&](const auto& add) {
      for (const Index f : faces)
        add(f, key_of_sides(raw.surface, f));
    },
    [&](Index f, Index g) { return are_equal_faces(raw.surface, f, g); },
    [&](Index f, Index first) {
      separate_from_neighbors(raw, f);
      arrays.normals[f] = {0, 0, 0};
      arrays.areas[f] = 0;
      added.push_back({first, f, 1, 0});
    });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_FIND_DOUBLED_FACES_H
