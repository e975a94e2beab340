// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_COLLECT_ADJACENCIES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_COLLECT_ADJACENCIES_H

#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/arrays.h>
#include <CGAL/Region_segmentation/internal/surface/Raw_surface.h>
#include <CGAL/Region_segmentation/internal/surface/compute_normals.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// An adjacency that is added to those across edges.
struct Added_adjacency
{
  Surface::Index lower, higher; ///< faces
  double squared_length;
  std::uint8_t flags;
  Surface::Index side = Surface::none, other_side = Surface::none; ///< of a seam: its corners
  Surface::Index place = Surface::none;                            ///< once it is inserted

  friend bool operator<(const Added_adjacency& a, const Added_adjacency& b)
  {
    return a.higher != b.higher ? a.higher < b.higher : a.lower < b.lower;
  }
};

/// A link between two faces, with the length of contact; 0 for a gap.
inline Added_adjacency link_of(Surface::Index f, Surface::Index g, double length)
{
  return {(std::min)(f, g), (std::max)(f, g), length * length, Surface::LINK};
}

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

/// Two vertices.
using Vertex_pair = std::pair<Surface::Index, Surface::Index>;

/// The coordinates of two points, the lower one first.
using Point_pair = std::array<std::array<double, 3>, 2>;

inline Point_pair point_pair(const Double_3& p, const Double_3& q)
{
  const std::array<double, 3> a{p.x, p.y, p.z}, b{q.x, q.y, q.z};
  return a < b ? Point_pair{a, b} : Point_pair{b, a};
}

/// Constrains the edges and seams between pairs of vertices. A vertex that no face uses, since its
/// point is that of another one, stands for all vertices with this point. O(F log C) for C pairs.
inline void mark_constraints(Surface& surface, const std::vector<Vertex_pair>& pairs)
{
  using Index = Surface::Index;
  if (pairs.empty())
    return;
  Surface_arrays& arrays = arrays_of(surface);
  std::vector<bool> is_used(surface.number_of_vertices());
  for (const Index v : arrays.corners)
    is_used[v] = true;
  std::vector<std::pair<Point_pair, Vertex_pair>> constrained;
  for (const Vertex_pair& pair : pairs)
    constrained.push_back(
      {point_pair(surface.point(pair.first), surface.point(pair.second)), pair});
  std::sort(constrained.begin(), constrained.end());
  const auto is_constrained = [&](Index v, Index w) {
    const auto is = [&](Index end, Index vertex) { return end == vertex || !is_used[end]; };
    const Point_pair points = point_pair(surface.point(v), surface.point(w));
    auto c = std::lower_bound(constrained.begin(), constrained.end(),
                              std::make_pair(points, Vertex_pair(0, 0)));
    for (; c != constrained.end() && c->first == points; ++c)
      if (const auto& [p, q] = c->second; (is(p, v) && is(q, w)) || (is(p, w) && is(q, v)))
        return true;
    return false;
  };
  for (Index f = 0; f < surface.number_of_faces(); ++f) {
    Index side = arrays.first_corners[f];
    for_each_side(surface, f, [&](Index v, Index w) {
      if (const Index a = arrays.adjacencies[side++]; a != Surface::none && is_constrained(v, w))
        arrays.flags[a] |= Surface::CONSTRAINED;
    });
  }
  join_degenerate_faces(surface);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_COLLECT_ADJACENCIES_H
