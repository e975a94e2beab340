// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_COLLECT_ADJACENCIES_H
#define CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_COLLECT_ADJACENCIES_H

#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/read_surface.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The area vector of a polygon, by Newell's formula relative to the first corner, A = 1/2 sum
/// (p_i - p_0) x (p_i+1 - p_0), which avoids cancellation far from the origin.
/// `first`, `past`: its corners; `points`: by vertex
inline Double_3 area_vector(const Double_3* points, const Surface::Index* first,
                            const Surface::Index* past)
{
  const Double_3& origin = points[*first];
  Double_3 twice_area{};
  for (const Surface::Index* c = first + 1; c + 1 < past; ++c)
    twice_area = twice_area + cross(points[c[0]] - origin, points[c[1]] - origin);
  return 0.5 * twice_area;
}

/// The areas and normals of the faces. The normal of a face is zero, and the face thereby
/// degenerate, if its area is at most 1e-12 times the square of its longest edge.
inline void compute_normals(Surface& surface, const Execution& execution)
{
  Surface_arrays& arrays = arrays_of(surface);
  const std::size_t size = arrays.first_corners.size() - 1;
  arrays.normals.resize(size);
  arrays.areas.resize(size);
  // Through references to the arrays it takes twice as long.
  const Double_3* const points = arrays.points.data();
  const Surface::Index *const corners = arrays.corners.data(),
                              *const first_corners = arrays.first_corners.data();
  double* const areas = arrays.areas.data();
  Double_3* const normals = arrays.normals.data();
  for_each_block(execution, size, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const Surface::Index *const first = corners + first_corners[f],
                                  *const past = corners + first_corners[f + 1];
      double squared_longest_edge = 0;
      for (const Surface::Index *previous = past - 1, *c = first; c != past; previous = c++)
        squared_longest_edge = (std::max)(squared_longest_edge,
                                          squared_norm(points[*c] - points[*previous]));
      const Double_3 vector = area_vector(points, first, past);
      const double area = areas[f] = norm(vector);
      const bool has_normal = area > 1e-12 * squared_longest_edge &&
                              area >= (std::numeric_limits<double>::min)();
      normals[f] = has_normal ? (1 / area) * vector : Double_3{};
    }
  });
}

/// The flag of the sign of the angle between two faces, from the normals of the higher and the
/// lower face, and the direction in which the boundary of the higher face runs along their edge.
inline std::uint8_t sign_of_edge(const Double_3& higher, const Double_3& lower,
                                 const Double_3& direction)
{
  const double sign = dot(cross(higher, lower), direction);
  return std::uint8_t((sign > 0) * Surface::CONVEX + (sign < 0) * Surface::CONCAVE);
}

/// An adjacency that is added to those across edges.
struct Added_adjacency
{
  Surface::Index lower, higher; ///< faces
  double squared_length;
  std::uint8_t flags;
  Surface::Index face = Surface::none; ///< the face whose side between `v` and `w` has it, if any
  Surface::Index v = 0, w = 0;         ///< vertices
};

/// A link between two faces, with the length of their contact, which is 0 for a gap.
inline Added_adjacency link_of(Surface::Index f, Surface::Index g, double length)
{
  return {(std::min)(f, g), (std::max)(f, g), length * length, Surface::LINK};
}

/// The seam across the side of a face f between the vertices v and w, with a share of its length;
/// an edge if one of the faces is degenerate.
inline Added_adjacency seam_between(const Surface& surface, Surface::Index f, Surface::Index g,
                                    Surface::Index v, Surface::Index w, double share)
{
  const bool is_edge = surface.is_degenerate(f) || surface.is_degenerate(g);
  return {(std::min)(f, g),
          (std::max)(f, g),
          share * share * squared_norm(surface.point(w) - surface.point(v)),
          std::uint8_t(is_edge ? 0 : Surface::SEAM),
          f,
          v,
          w};
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

/// Collects the adjacencies across edges, from the faces across the sides of each face. The
/// adjacencies of a face are ordered by the lower faces, several adjacencies to one face by the
/// boundary.
inline void collect_adjacencies(Raw_surface& raw, const Execution& execution)
{
  using Index = Surface::Index;
  Surface_arrays& arrays = arrays_of(raw.surface);
  resize_adjacencies(arrays, arrays.corners.size() / 2); // each one has two sides
  arrays.adjacencies.assign(arrays.corners.size(), Surface::none);
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
      for (Index side = arrays.first_corners[f]; side < arrays.first_corners[f + 1]; ++side)
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
        if (raw.surface.number_of_corners(lower) <= raw.surface.number_of_corners(f))
          arrays.adjacencies[side_across(raw, Index(f), side)] = Index(a);
        arrays.flags[a++] = sign_of_edge(arrays.normals[f], arrays.normals[lower], direction);
      }
    }
    return a;
  };
  resize_adjacencies(arrays,
                     for_each_block_of_output(execution, arrays.normals.size(), number_in, write));
  // The sides of lower faces with more corners than their neighbors: searching for each of these
  // sides would take quadratic time.
  for_each_index(execution.silent(), arrays.normals.size(), [&](std::size_t f) {
    for (Index side = arrays.first_corners[f]; side < arrays.first_corners[f + 1]; ++side)
      if (arrays.adjacencies[side] == Surface::none && Raw_surface::is_face(raw.neighbors[side]))
        arrays.adjacencies[side] = arrays.adjacencies[side_across(raw, Index(f), side)];
  });
}

/// Stores added adjacencies at the sides of their faces: always at that of `face`, and at that of
/// the other face if it has none. `places`: the indices of the added adjacencies
inline void set_sides(Surface& surface, const std::vector<Added_adjacency>& added,
                      const Surface::Index* places)
{
  Large_array<Surface::Index>& adjacencies = arrays_of(surface).adjacencies;
  for (const bool is_other : {false, true})
    for (std::size_t i = 0; i < added.size(); ++i)
      if (const Added_adjacency& s = added[i]; s.face != Surface::none) {
        const Surface::Index face = is_other ? s.lower + s.higher - s.face : s.face;
        Surface::Index& a = adjacencies[side_between(surface, face, s.v, s.w)];
        a = is_other && a != Surface::none ? a : places[i];
      }
}

/// Inserts adjacencies. Each follows the existing ones between the same two faces.
inline void insert_adjacencies(Surface& surface, const std::vector<Added_adjacency>& added)
{
  using Index = Surface::Index;
  if (added.empty())
    return;
  Surface_arrays& arrays = arrays_of(surface);
  const std::size_t size = arrays.flags.size();
  for (const Added_adjacency& a : added) {
    arrays.lower_faces.push_back(a.lower);
    arrays.higher_faces.push_back(a.higher);
    arrays.squared_lengths.push_back(a.squared_length);
    arrays.flags.push_back(a.flags);
    arrays.has_seams_or_links |= (a.flags & (Surface::SEAM | Surface::LINK)) != 0;
  }
  std::vector<Index> order(arrays.flags.size()), places(order.size());
  std::iota(order.begin(), order.end(), Index(0));
  const auto middle = order.begin() + std::ptrdiff_t(size);
  const auto is_before = [&](Index a, Index b) {
    return std::tie(arrays.higher_faces[a], arrays.lower_faces[a]) <
           std::tie(arrays.higher_faces[b], arrays.lower_faces[b]);
  };
  std::stable_sort(middle, order.end(), is_before);
  std::inplace_merge(order.begin(), middle, order.end(), is_before);
  const auto reorder = [&](auto& array) {
    auto old = array;
    for (std::size_t i = 0; i < order.size(); ++i)
      array[i] = old[order[i]];
  };
  reorder(arrays.lower_faces);
  reorder(arrays.higher_faces);
  reorder(arrays.squared_lengths);
  reorder(arrays.flags);
  for (std::size_t i = 0; i < order.size(); ++i)
    places[order[i]] = Index(i);
  for (Index& a : arrays.adjacencies)
    a = a == Surface::none ? a : places[a];
  set_sides(surface, added, places.data() + size);
}

/// Marks the adjacencies of degenerate faces: the longest edge of each that is not constrained
/// joins it, of equal ones that to the lowest face.
inline void join_degenerate_faces(Surface& surface)
{
  using Index = Surface::Index;
  Surface_arrays& arrays = arrays_of(surface);
  std::map<Index, Index> longest; // adjacency by degenerate face
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
      if (surface.has_flag(a, Surface::CONSTRAINED))
        continue;
      Index& best = longest.emplace(face, a).first->second;
      best = key(a, face) < key(best, face) ? a : best;
    }
  for (const auto& [face, a] : longest)
    arrays.flags[a] = Surface::JOINING;
}

/// Sets the signs of all angles by the normals. A seam has a sign if the boundaries of its faces
/// run along it in opposite directions.
inline void set_signs(Surface& surface)
{
  using Index = Surface::Index;
  Surface_arrays& arrays = arrays_of(surface);
  for_each_side_of_surface(surface, [&](Index f, Index v, Index w, Index a) {
    if (a == Surface::none || surface.has_flag(a, Surface::without_angle))
      return;
    const Index lower = arrays.lower_faces[a], higher = arrays.higher_faces[a];
    const Double_3 direction = surface.point(w) - surface.point(v);
    arrays.flags[a] &= std::uint8_t(~(Surface::CONVEX | Surface::CONCAVE));
    if (!surface.has_flag(a, Surface::SEAM) ||
        arrays.corners[side_between(surface, lower + higher - f, v, w)] == w)
      arrays.flags[a] |= sign_of_edge(surface.normal(higher), surface.normal(lower),
                                      (f == higher ? 1.0 : -1.0) * direction);
  });
}

/// Sets the area of the surface, the sum of the weights of the faces.
inline void sum_up(Surface& surface)
{
  arrays_of(surface).area = 0;
  for (std::size_t f = 0; f < surface.number_of_faces(); ++f)
    arrays_of(surface).area += surface.weight(f);
}

/// The vertex of the surface at the point of a vertex of the input.
inline Surface::Index merged_vertex(const Surface& surface, Surface::Index v)
{
  const auto& merged = arrays_of(surface).merged_vertices;
  return merged.empty() ? v : merged[v];
}

/// Two vertices.
using Vertex_pair = std::pair<Surface::Index, Surface::Index>;

/// Constrains the edges and seams between pairs of vertices of the input. O(F log C) for C pairs.
inline void mark_constraints(Surface& surface, std::vector<Vertex_pair> pairs)
{
  using Index = Surface::Index;
  if (pairs.empty())
    return;
  Surface_arrays& arrays = arrays_of(surface);
  for (auto& [v, w] : pairs)
    std::tie(v, w) = std::minmax({merged_vertex(surface, v), merged_vertex(surface, w)});
  std::sort(pairs.begin(), pairs.end());
  for_each_side_of_surface(surface, [&](Index, Index v, Index w, Index a) {
    if (a != Surface::none &&
        std::binary_search(pairs.begin(), pairs.end(), Vertex_pair(std::minmax(v, w))))
      arrays.flags[a] |= Surface::CONSTRAINED;
  });
  join_degenerate_faces(surface);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_COLLECT_ADJACENCIES_H
