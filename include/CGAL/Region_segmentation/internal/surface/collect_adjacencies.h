// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_COLLECT_ADJACENCIES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_COLLECT_ADJACENCIES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/support/Function_ref.h>
#include <CGAL/Region_segmentation/internal/surface/Added_adjacency.h>
#include <CGAL/Region_segmentation/internal/surface/Raw_surface.h>
#include <CGAL/Region_segmentation/internal/surface/compute_normals.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

inline void resize_adjacencies(Surface_arrays& arrays, std::size_t size)
{
  arrays.lower_faces.resize(size);
  arrays.higher_faces.resize(size);
  arrays.squared_lengths.resize(size);
  arrays.flags.resize(size);
}

/// The corner from which the side of a face between two vertices leaves, in either direction;
/// `none` if there is no such side. O(n) for n corners.
inline Surface::Index side_between(const Surface& surface, Surface::Index face, Surface::Index v,
                                   Surface::Index w)
{
  Surface::Index side = arrays_of(surface).first_corners[face], result = Surface::none;
  for_each_side(surface, face, [&](Surface::Index from, Surface::Index to) {
    result = std::minmax(from, to) == std::minmax(v, w) ? side : result;
    ++side;
  });
  return result;
}

/// The adjacencies across edges, from the faces across the sides of each face. Those of a face by
/// the lower faces, of several to one in the order of the boundary.
inline void collect_adjacencies(Raw_surface& raw, const Execution& execution)
{
  using Index = Surface::Index;
  Surface_arrays& arrays = arrays_of(raw.surface);
  resize_adjacencies(arrays, arrays.corners.size() / 2); // each one has two sides
  arrays.adjacencies.resize(arrays.corners.size());
  for_each_index(execution.silent(), arrays.corners.size(),
                 [&](std::size_t side) { arrays.adjacencies[side] = Surface::none; });
  // Of two faces that with fewer corners is searched for their common side.
  std::atomic<bool> has_large_face(false);
  const auto has_fewer_corners = [&](std::size_t f, std::size_t g) {
    return arrays.first_corners[f + 1] - arrays.first_corners[f] <
           arrays.first_corners[g + 1] - arrays.first_corners[g];
  };
  const auto number_in = [&](std::size_t, std::size_t begin, std::size_t end) {
    std::size_t result = 0;
    for (std::size_t f = begin; f < end; ++f)
      for (Index c = arrays.first_corners[f]; c < arrays.first_corners[f + 1]; ++c)
        result += raw.neighbors[c] < f;
    return result;
  };
  const auto write = [&](std::size_t, std::size_t begin, std::size_t end, std::size_t a) {
    std::vector<std::pair<Index, Index>> sides; // of a face: the lower face across, and the side
    for (std::size_t f = begin; f < end; ++f) {
      sides.clear();
      const Index end_of_face = arrays.first_corners[f + 1];
      for (Index side = arrays.first_corners[f]; side < end_of_face; ++side)
        if (const Index lower = raw.neighbors[side]; lower < f)
          sides.push_back({lower, side});
      if (sides.size() > 1)
        std::sort(sides.begin(), sides.end());
      for (const auto& [lower, side] : sides) {
        const Double_3 direction = arrays.points[arrays.corners[next_corner(arrays, f, side)]] -
                                   arrays.points[arrays.corners[side]];
        arrays.lower_faces[a] = lower;
        arrays.higher_faces[a] = Index(f);
        arrays.squared_lengths[a] = squared_norm(direction);
        arrays.adjacencies[side] = Index(a);
        if (has_fewer_corners(f, lower)) // the side of the lower face follows below
          has_large_face = true;
        else
          arrays.adjacencies[side_across(raw, Index(f), side)] = Index(a);
        arrays.flags[a++] = sign_of_edge(arrays.normals[f], arrays.normals[lower], direction);
      }
    }
    return a;
  };
  resize_adjacencies(arrays,
                     for_each_block_of_output(execution, arrays.normals.size(), number_in, write));
  for (Index f = 0; has_large_face && f < arrays.normals.size(); ++f)
    for (Index side = arrays.first_corners[f]; side < arrays.first_corners[f + 1]; ++side)
      if (const Index g = raw.neighbors[side];
          Raw_surface::is_face(g) && g > f && has_fewer_corners(g, f))
        arrays.adjacencies[side] = arrays.adjacencies[side_across(raw, f, side)];
}

/// Inserts adjacencies behind those of the same two faces.
inline void insert_adjacencies(Surface& surface, std::vector<Added_adjacency> added)
{
  if (added.empty())
    return;
  std::stable_sort(added.begin(), added.end());
  Surface_arrays& arrays = arrays_of(surface);
  std::size_t from = arrays.flags.size(), to = from + added.size();
  std::vector<Surface::Index> new_places(from); // of the adjacencies that there are
  resize_adjacencies(arrays, to);
  for (std::size_t i = added.size(); i > 0;) {
    --to;
    const Added_adjacency& a = added[i - 1];
    if (from > 0 && std::tie(a.higher, a.lower) <
                      std::tie(arrays.higher_faces[from - 1], arrays.lower_faces[from - 1])) {
      --from;
      new_places[from] = Surface::Index(to);
      arrays.lower_faces[to] = arrays.lower_faces[from];
      arrays.higher_faces[to] = arrays.higher_faces[from];
      arrays.squared_lengths[to] = arrays.squared_lengths[from];
      arrays.flags[to] = arrays.flags[from];
    } else {
      arrays.lower_faces[to] = a.lower;
      arrays.higher_faces[to] = a.higher;
      arrays.squared_lengths[to] = a.squared_length;
      arrays.flags[to] = a.flags;
      added[--i].place = Surface::Index(to);
      arrays.has_seams_or_links |= (a.flags & (Surface::SEAM | Surface::LINK)) != 0;
    }
  }
  std::iota(new_places.begin(), new_places.begin() + std::ptrdiff_t(from), Surface::Index(0));
  for (Surface::Index& a : arrays.adjacencies)
    a = a == Surface::none ? a : new_places[a];
  for (const Added_adjacency& a : added)
    if (a.side != Surface::none)
      arrays.adjacencies[a.side] = a.place;
  for (const Added_adjacency& a : added)
    if (a.other_side != Surface::none && arrays.adjacencies[a.other_side] == Surface::none)
      arrays.adjacencies[a.other_side] = a.place;
}

/// Marks the adjacencies of degenerate faces: the longest edge of each that is not constrained
/// joins it, of equal ones that to the lowest face.
inline void join_degenerate_faces(Surface& surface)
{
  using Index = Surface::Index;
  Surface_arrays& arrays = arrays_of(surface);
  std::vector<Index> longest; // by face
  const auto key = [&](Index a, Index face) {
    const Index lower = surface.lower_face(a);
    return std::make_pair(-surface.squared_length(a),
                          lower == face ? surface.higher_face(a) : lower);
  };
  for (Index a = 0; a < surface.number_of_adjacencies(); ++a)
    for (const Index face : {surface.lower_face(a), surface.higher_face(a)}) {
      if (!surface.is_degenerate(face) || surface.has_flag(a, Surface::LINK))
        continue;
      arrays.flags[a] = std::uint8_t((arrays.flags[a] & Surface::CONSTRAINED) | Surface::CLOSED);
      longest.resize(surface.number_of_faces(), Surface::none);
      if (!surface.has_flag(a, Surface::CONSTRAINED) &&
          (longest[face] == Surface::none || key(a, face) < key(longest[face], face)))
        longest[face] = a;
    }
  for (const Index a : longest)
    if (a != Surface::none)
      arrays.flags[a] = Surface::JOINING;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_COLLECT_ADJACENCIES_H
