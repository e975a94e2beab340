// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_COLLECT_ADJACENCIES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_COLLECT_ADJACENCIES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/surface/Raw_surface.h>
#include <CGAL/Region_segmentation/internal/surface/compute_normals.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Sorts the sides of a face that lead to lower faces by these, of several in order. Returns their
/// number.
template <typename Side>
std::size_t sort_sides(const Surface::Index* neighbors, std::size_t number_of_sides,
                       Surface::Index face, Side* sides)
{
  std::size_t n = 0;
  for (std::size_t i = 0; i < number_of_sides; ++i)
    if (neighbors[i] < face) {
      std::size_t place = n++;
      if (number_of_sides <= 8)
        for (; place > 0 && sides[place - 1].first > neighbors[i]; --place)
          sides[place] = sides[place - 1];
      sides[place] = {neighbors[i], Surface::Index(i)};
    }
  if (number_of_sides > 8)
    std::sort(sides, sides + n);
  return n;
}

/// The adjacencies across edges, from the faces across the sides of each face.
inline void collect_adjacencies(Raw_surface& raw, const Execution& execution)
{
  using Index = Surface::Index;
  Surface_arrays& arrays = arrays_of(raw.surface);
  const std::size_t size = arrays.normals.size();
  const Index *const first_corners = arrays.first_corners.data(), *const neighbors = raw.neighbors
                                                                                       .data();
  const std::vector<std::size_t> offsets = block_offsets(
    execution.step(0, 0.2), size, [&](std::size_t, std::size_t begin, std::size_t end) {
      std::size_t number = 0;
      for (std::size_t f = begin; f < end; ++f)
        for (Index c = first_corners[f]; c < first_corners[f + 1]; ++c)
          number += neighbors[c] < f;
      return number;
    });
  arrays.lower_faces.resize(offsets.back());
  arrays.higher_faces.resize(offsets.back());
  arrays.squared_lengths.resize(offsets.back());
  arrays.flags.resize(offsets.back());
  const Double_3 *const points = arrays.points.data(), *const normals = arrays.normals.data();
  const Index* const corners = arrays.corners.data();
  Index *const lower_faces = arrays.lower_faces.data(), *const higher_faces = arrays.higher_faces
                                                                                .data();
  double* const squared_lengths = arrays.squared_lengths.data();
  std::uint8_t* const flags = arrays.flags.data();
  for_each_block(
    execution.step(0.2, 1), size, [&](std::size_t block, std::size_t begin, std::size_t end) {
      std::vector<std::pair<Index, Index>> sides(16); // the face across, the side
      std::size_t a = offsets[block];
      for (std::size_t f = begin; f < end; ++f) {
        const Index first = first_corners[f], number_of_sides = first_corners[f + 1] - first;
        if (sides.size() < number_of_sides)
          sides.resize(number_of_sides);
        const std::size_t n = sort_sides(neighbors + first, number_of_sides, Index(f),
                                         sides.data());
        for (std::size_t i = 0; i < n; ++i, ++a) {
          const Index lower = sides[i].first, side = first + sides[i].second;
          const Index next = side + 1 < first + number_of_sides ? side + 1 : first;
          const Double_3 direction = points[corners[next]] - points[corners[side]];
          lower_faces[a] = lower;
          higher_faces[a] = Index(f);
          squared_lengths[a] = squared_norm(direction);
          flags[a] = sign_of_edge(normals[f], normals[lower], direction);
        }
      }
    });
}

/// An adjacency that is added to those across edges.
struct Added_adjacency
{
  Surface::Index lower, higher;
  double squared_length;
  std::uint8_t flags;
};

/// Inserts adjacencies behind those of the same two faces.
inline void insert_adjacencies(Surface& surface, const std::vector<Added_adjacency>& added)
{
  if (added.empty())
    return;
  using Index = Surface::Index;
  const auto key = [](Index higher, Index lower) { return (std::uint64_t(higher) << 32) | lower; };
  std::vector<std::pair<std::uint64_t, Index>> order; // in which to insert
  for (const Added_adjacency& a : added)
    order.push_back({key(a.higher, a.lower), Index(order.size())});
  std::sort(order.begin(), order.end());

  Surface_arrays& arrays = arrays_of(surface);
  std::size_t from = arrays.flags.size(), to = from + added.size();
  arrays.lower_faces.resize(to);
  arrays.higher_faces.resize(to);
  arrays.squared_lengths.resize(to);
  arrays.flags.resize(to);
  for (std::size_t i = added.size(); i > 0;) {
    --to;
    if (from > 0 &&
        key(arrays.higher_faces[from - 1], arrays.lower_faces[from - 1]) > order[i - 1].first) {
      --from;
      arrays.lower_faces[to] = arrays.lower_faces[from];
      arrays.higher_faces[to] = arrays.higher_faces[from];
      arrays.squared_lengths[to] = arrays.squared_lengths[from];
      arrays.flags[to] = arrays.flags[from];
    } else {
      const Added_adjacency& a = added[order[--i].second];
      arrays.lower_faces[to] = a.lower;
      arrays.higher_faces[to] = a.higher;
      arrays.squared_lengths[to] = a.squared_length;
      arrays.flags[to] = a.flags;
      arrays.has_seams_or_links |= (a.flags & (Surface::SEAM | Surface::LINK)) != 0;
    }
  }
}

/// The longest adjacency of each degenerate face, among those that `is_candidate(adjacency)`; of
/// equal ones that to the lowest face. Sorted.
template <typename IsCandidate>
std::vector<Surface::Index> longest_edges_of_degenerate_faces(const Surface& surface,
                                                              const IsCandidate& is_candidate)
{
  using Index = Surface::Index;
  constexpr Index none = (std::numeric_limits<Index>::max)();
  std::vector<Index> longest(surface.number_of_faces(), none);
  const auto key = [&](Index a, Index face) {
    const Index lower = surface.lower_face(a);
    return std::make_pair(-surface.squared_length(a),
                          lower == face ? surface.higher_face(a) : lower);
  };
  for (Index a = 0; a < surface.number_of_adjacencies(); ++a)
    for (const Index face : {surface.lower_face(a), surface.higher_face(a)})
      if (surface.is_degenerate(face) && is_candidate(a) &&
          (longest[face] == none || key(a, face) < key(longest[face], face)))
        longest[face] = a;
  std::sort(longest.begin(), longest.end());
  longest.erase(std::unique(longest.begin(), longest.end()), longest.end());
  if (!longest.empty() && longest.back() == none)
    longest.pop_back();
  return longest;
}

/// Marks the adjacencies of degenerate faces: the longest edge of each joins it.
inline void join_degenerate_faces(Surface& surface)
{
  Surface_arrays& arrays = arrays_of(surface);
  const auto is_zero = [](const Double_3& n) { return n.x == 0 && n.y == 0 && n.z == 0; };
  if (std::none_of(arrays.normals.begin(), arrays.normals.end(), is_zero))
    return;
  const auto is_edge = [&](std::size_t a) { return !surface.has_flag(a, Surface::LINK); };
  const auto joining = longest_edges_of_degenerate_faces(surface, is_edge);
  for (std::size_t a = 0; a < arrays.flags.size(); ++a)
    if (is_edge(a) && (surface.is_degenerate(arrays.lower_faces[a]) ||
                       surface.is_degenerate(arrays.higher_faces[a])))
      arrays.flags[a] = Surface::CLOSED;
  for (const Surface::Index a : joining)
    arrays.flags[a] = Surface::JOINING;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_COLLECT_ADJACENCIES_H
