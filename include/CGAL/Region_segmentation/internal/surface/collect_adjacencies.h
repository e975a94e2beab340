// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_COLLECT_ADJACENCIES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_COLLECT_ADJACENCIES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/internal/support/Function_ref.h>
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

/// A side of a face that leads to a lower one: this one and the side as one number, and the face.
using Side_to_lower_face = std::pair<std::uint64_t, Surface::Index>;

/// Appends the sides of a face that lead to lower ones, by these, of several in the order of the
/// boundary. Returns the new end; behind it there is room for two more.
///
/// Which sides of a triangle lead to lower faces, and in which order, is unpredictable. So all
/// three are written, those that lead to no lower face last, where the next face overwrites them.
inline Side_to_lower_face* add_sides_to_lower_faces(const Raw_surface& raw, Surface::Index face,
                                                    Side_to_lower_face* end)
{
  using Index = Surface::Index;
  const Index* const neighbors = raw.neighbors.data();
  const Index first = arrays_of(raw.surface).first_corners[face],
              past = arrays_of(raw.surface).first_corners[face + 1];
  const auto key = [=](Index side) { return (std::uint64_t(neighbors[side]) << 32) | side; };
  if (past - first == 3) {
    const auto key_or_highest = [=](Index side) {
      return key(side) | (std::uint64_t(0) - std::uint64_t(neighbors[side] >= face));
    };
    const std::uint64_t a = key_or_highest(first), b = key_or_highest(first + 1),
                        c = key_or_highest(first + 2);
    const unsigned b_a = b < a, c_a = c < a, c_b = c < b;
    end[b_a + c_a] = {a, face};
    end[1 - b_a + c_b] = {b, face};
    end[2 - c_a - c_b] = {c, face};
    return end + (neighbors[first] < face) + (neighbors[first + 1] < face) +
           (neighbors[first + 2] < face);
  }
  Side_to_lower_face* const begin = end;
  for (Index side = first; side < past; ++side)
    if (neighbors[side] < face)
      *end++ = {key(side), face};
  std::sort(begin, end);
  return end;
}

inline void resize_adjacencies(Surface_arrays& arrays, std::size_t size)
{
  arrays.lower_faces.resize(size);
  arrays.higher_faces.resize(size);
  arrays.squared_lengths.resize(size);
  arrays.flags.resize(size);
}

/// The adjacencies across edges, from the faces across the sides of each face.
inline void collect_adjacencies(Raw_surface& raw, const Execution& execution)
{
  using Index = Surface::Index;
  Surface_arrays& arrays = arrays_of(raw.surface);
  resize_adjacencies(arrays, arrays.corners.size() / 2); // each one has two sides
  const Double_3 *const points = arrays.points.data(), *const normals = arrays.normals.data();
  const Index *const corners = arrays.corners.data(), *const neighbors = raw.neighbors.data(),
                     *const first_corners = arrays.first_corners.data();
  Index *const lower_faces = arrays.lower_faces.data(), *const higher_faces = arrays.higher_faces
                                                                                .data();
  double* const squared_lengths = arrays.squared_lengths.data();
  std::uint8_t* const flags = arrays.flags.data();
  const auto number_in = [=](std::size_t, std::size_t begin, std::size_t end) {
    std::size_t result = 0;
    for (std::size_t f = begin; f < end; ++f)
      for (Index c = first_corners[f]; c < first_corners[f + 1]; ++c)
        result += neighbors[c] < f;
    return result;
  };
  const auto write = [=, &raw](std::size_t, std::size_t begin, std::size_t end, std::size_t a) {
    constexpr std::size_t at_once = 256; // small enough for the cache
    std::vector<Side_to_lower_face> sides;
    for (std::size_t f = begin, past; f < end; f = past) {
      past = (std::min)(f + at_once, end);
      sides.resize(
        (std::max)(sides.size(), first_corners[past] - first_corners[f] + std::size_t(2)));
      Side_to_lower_face* end_of_sides = sides.data();
      for (; f < past; ++f)
        end_of_sides = add_sides_to_lower_faces(raw, Index(f), end_of_sides);
      for (const Side_to_lower_face* s = sides.data(); s != end_of_sides; ++s, ++a) {
        const Index lower = Index(s->first >> 32), side = Index(s->first), higher = s->second;
        const Index next = side + 1 < first_corners[higher + 1] ? side + 1 : first_corners[higher];
        const Double_3 direction = points[corners[next]] - points[corners[side]];
        lower_faces[a] = lower;
        higher_faces[a] = higher;
        squared_lengths[a] = squared_norm(direction);
        flags[a] = sign_of_edge(normals[higher], normals[lower], direction);
      }
    }
    return a;
  };
  resize_adjacencies(arrays,
                     for_each_block_of_output(execution, arrays.normals.size(), number_in, write));
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
  std::sort(order.data(), order.data() + order.size());

  Surface_arrays& arrays = arrays_of(surface);
  std::size_t from = arrays.flags.size(), to = from + added.size();
  resize_adjacencies(arrays, to);
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
/// equal ones that to the lowest face.
inline std::vector<Surface::Index>
longest_edges_of_degenerate_faces(const Surface& surface,
                                  Function_ref<bool(std::size_t)> is_candidate)
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
  longest.erase(std::remove(longest.begin(), longest.end(), none), longest.end());
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
