// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_COLLECT_ADJACENCIES_H
#define CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_COLLECT_ADJACENCIES_H

#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/Surface_builder.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

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
inline void Surface_builder::compute_normals(const Execution& execution)
{
  const std::size_t size = number_of_faces();
  m_normals.resize(size);
  m_areas.resize(size);
  // With the members in place of pointers this loop takes twice as long.
  const Double_3* const points = m_points.data();
  const Index *const corners = m_corners.data(), *const first_corners = m_first_corners.data();
  double* const areas = m_areas.data();
  Double_3* const normals = m_normals.data();
  for_each_block(execution, size, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const Index *const first = corners + first_corners[f], *const past = corners +
                                                                           first_corners[f + 1];
      double squared_longest_edge = 0;
      for (const Index *previous = past - 1, *c = first; c != past; previous = c++)
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

inline void Surface_builder::resize_adjacencies(std::size_t size)
{
  m_lower_faces.resize(size);
  m_higher_faces.resize(size);
  m_squared_lengths.resize(size);
  m_flags.resize(size);
}

/// Collects the adjacencies across edges, from the faces across the sides of each face. The
/// adjacencies of a face are ordered by the lower faces, several adjacencies to one face by the
/// boundary.
inline void Surface_builder::collect_edges(const Execution& execution)
{
  resize_adjacencies(m_corners.size() / 2); // an adjacency has two sides
  m_adjacencies.assign(m_corners.size(), none);
  const auto number_in = [&](std::size_t, std::size_t begin, std::size_t end) {
    std::size_t result = 0;
    for (std::size_t f = begin; f < end; ++f)
      for (Index c = m_first_corners[f]; c < m_first_corners[f + 1]; ++c)
        result += m_neighbors[c] < f;
    return result;
  };
  const auto write = [&](std::size_t, std::size_t begin, std::size_t end, std::size_t a) {
    std::vector<std::pair<Index, Index>> sides; // of a face: the lower face across, and the side
    for (std::size_t f = begin; f < end; ++f) {
      sides.clear();
      for (Index side = m_first_corners[f]; side < m_first_corners[f + 1]; ++side)
        if (const Index lower = m_neighbors[side]; lower < f)
          sides.push_back({lower, side});
      if (sides.size() > 1)
        std::sort(sides.begin(), sides.end());
      for (const auto& [lower, side] : sides) {
        const Double_3 direction = m_points[m_corners[next_corner(f, side)]] -
                                   m_points[m_corners[side]];
        m_lower_faces[a] = lower;
        m_higher_faces[a] = Index(f);
        m_squared_lengths[a] = squared_norm(direction);
        m_adjacencies[side] = Index(a);
        if (number_of_corners(lower) <= number_of_corners(f))
          m_adjacencies[side_across(Index(f), side)] = Index(a);
        m_flags[a++] = sign_of_edge(m_normals[f], m_normals[lower], direction);
      }
    }
    return a;
  };
  resize_adjacencies(for_each_block_of_output(execution, m_normals.size(), number_in, write));
  // The sides of lower faces with more corners than their neighbors: searching for each of these
  // sides would take quadratic time.
  for_each_index(execution.silent(), m_normals.size(), [&](std::size_t f) {
    for (Index side = m_first_corners[f]; side < m_first_corners[f + 1]; ++side)
      if (m_adjacencies[side] == none && is_face(m_neighbors[side]))
        m_adjacencies[side] = m_adjacencies[side_across(Index(f), side)];
  });
}

/// Collects the adjacencies across edges and seams, and the components.
inline void Surface_builder::collect_adjacencies(const Execution& execution)
{
  collect_edges(execution.step(0, 0.8));
  m_neighbors = Large_array<Index>(); // the next steps need the memory
  insert_adjacencies(std::exchange(m_added, {}));
  m_component_of = label_components(*this, m_flags.data(), SEAM | LINK, execution.step(0.8, 1));
}

/// Stores added adjacencies at the sides of their faces: always at that of `face`, and at that of
/// the other face if it has none. `places`: the indices of the added adjacencies
inline void Surface_builder::set_sides(const std::vector<Added_adjacency>& added,
                                       const Index* places)
{
  for (const bool is_other : {false, true})
    for (std::size_t i = 0; i < added.size(); ++i)
      if (const Added_adjacency& s = added[i]; s.face != none) {
        const Index face = is_other ? s.lower + s.higher - s.face : s.face;
        Index& a = m_adjacencies[side_between(face, s.v, s.w)];
        a = is_other && a != none ? a : places[i];
      }
}

/// Inserts adjacencies. Each follows the existing ones between the same two faces.
inline void Surface_builder::insert_adjacencies(const std::vector<Added_adjacency>& added)
{
  if (added.empty())
    return;
  const std::size_t size = m_flags.size();
  for (const Added_adjacency& a : added) {
    m_lower_faces.push_back(a.lower);
    m_higher_faces.push_back(a.higher);
    m_squared_lengths.push_back(a.squared_length);
    m_flags.push_back(a.flags);
    m_has_seams_or_links |= (a.flags & (SEAM | LINK)) != 0;
  }
  std::vector<Index> order(m_flags.size()), places(order.size());
  std::iota(order.begin(), order.end(), Index(0));
  const auto middle = order.begin() + std::ptrdiff_t(size);
  const auto is_before = [&](Index a, Index b) {
    return std::tie(m_higher_faces[a], m_lower_faces[a]) <
           std::tie(m_higher_faces[b], m_lower_faces[b]);
  };
  std::stable_sort(middle, order.end(), is_before);
  std::inplace_merge(order.begin(), middle, order.end(), is_before);
  const auto reorder = [&](auto& array) {
    auto old = array;
    for (std::size_t i = 0; i < order.size(); ++i)
      array[i] = old[order[i]];
  };
  reorder(m_lower_faces);
  reorder(m_higher_faces);
  reorder(m_squared_lengths);
  reorder(m_flags);
  for (std::size_t i = 0; i < order.size(); ++i)
    places[order[i]] = Index(i);
  for (Index& a : m_adjacencies)
    a = a == none ? a : places[a];
  set_sides(added, places.data() + size);
}

/// Marks the adjacencies of degenerate faces: the longest edge of each that is not constrained
/// joins it, of equal ones that to the lowest face.
inline void Surface_builder::join_degenerate_faces()
{
  std::map<Index, Index> longest; // adjacency by degenerate face
  const auto key = [&](Index a, Index face) {
    const Index lower = lower_face(a);
    return std::make_pair(-squared_length(a), lower == face ? higher_face(a) : lower);
  };
  for (Index a = 0; a < number_of_adjacencies(); ++a)
    for (const Index face : {lower_face(a), higher_face(a)}) {
      if (!is_degenerate(face) || has_flag(a, LINK))
        continue;
      m_flags[a] = std::uint8_t((m_flags[a] & CONSTRAINED) | CLOSED);
      if (has_flag(a, CONSTRAINED))
        continue;
      Index& best = longest.emplace(face, a).first->second;
      best = key(a, face) < key(best, face) ? a : best;
    }
  for (const auto& [face, a] : longest)
    m_flags[a] = JOINING;
}

/// The new numbers of the items that stay, in their order; `Surface::none` of the others.
template <typename Stays>
std::vector<Surface::Index> number_what_stays(std::size_t size, const Stays& stays)
{
  std::vector<Surface::Index> result;
  Surface::Index number = 0;
  for (std::size_t i = 0; i < size; ++i)
    result.push_back(stays(i) ? number++ : Surface::none);
  return result;
}

/// Removes the items of an array without a new number.
template <typename Array>
void keep_what_stays(Array& array, const std::vector<Surface::Index>& numbers)
{
  std::size_t size = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers[i] != Surface::none)
      array[size++] = array[i];
  array.resize(size);
}

/// Removes faces and all links; the vertices stay. Returns the new numbers of the faces.
inline std::vector<Surface::Index>
Surface_builder::remove_faces(const std::vector<bool>& is_removed)
{
  const auto new_faces = number_what_stays(is_removed.size(),
                                           [&](std::size_t f) { return !is_removed[f]; });
  const auto new_adjacencies = number_what_stays(number_of_adjacencies(), [&](std::size_t a) {
    return !is_removed[lower_face(a)] && !is_removed[higher_face(a)] && !has_flag(a, LINK);
  });
  std::vector<Index> new_corners;
  Large_array<Index> first_corners(1, 0);
  for (std::size_t f = 0; f < is_removed.size(); ++f) {
    const Index begin = first_corners.back();
    for (Index i = 0; i < number_of_corners(f); ++i)
      new_corners.push_back(is_removed[f] ? none : begin + i);
    if (!is_removed[f])
      first_corners.push_back(begin + Index(number_of_corners(f)));
  }
  m_first_corners = std::move(first_corners);
  keep_what_stays(m_normals, new_faces);
  keep_what_stays(m_areas, new_faces);
  keep_what_stays(m_corners, new_corners);
  keep_what_stays(m_adjacencies, new_corners);
  for (Index& a : m_adjacencies)
    a = a == none ? none : new_adjacencies[a];
  for (Large_array<Index>* faces : {&m_lower_faces, &m_higher_faces}) {
    keep_what_stays(*faces, new_adjacencies);
    for (Index& f : *faces)
      f = new_faces[f];
  }
  keep_what_stays(m_squared_lengths, new_adjacencies);
  keep_what_stays(m_flags, new_adjacencies);
  m_adjacencies_in_mesh.clear();
  m_crumbs.clear();
  m_bodies.clear();
  m_has_seams_or_links = std::any_of(m_flags.begin(), m_flags.end(),
                                     [](std::uint8_t flags) { return (flags & SEAM) != 0; });
  m_component_of = label_components(*this, m_flags.data(), SEAM | LINK, Execution());
  return new_faces;
}

/// Sets the signs of all angles by the normals. A seam has a sign if the boundaries of its faces
/// run along it in opposite directions.
inline void Surface_builder::set_signs()
{
  for_each_side_of_surface(*this, [&](Index f, Index v, Index w, Index a) {
    if (a == none || has_flag(a, without_angle))
      return;
    const Index lower = m_lower_faces[a], higher = m_higher_faces[a];
    const Double_3 direction = point(w) - point(v);
    m_flags[a] &= std::uint8_t(~(CONVEX | CONCAVE));
    if (!has_flag(a, SEAM) || m_corners[side_between(lower + higher - f, v, w)] == w)
      m_flags[a] |= sign_of_edge(normal(higher), normal(lower),
                                 (f == higher ? 1.0 : -1.0) * direction);
  });
}

/// Constrains the edges and seams between pairs of vertices of the input. O(F log C) for C pairs.
inline void Surface_builder::mark_constraints(std::vector<Vertex_pair> pairs)
{
  if (pairs.empty())
    return;
  for (auto& [v, w] : pairs)
    std::tie(v, w) = std::minmax({merged_vertex(v), merged_vertex(w)});
  std::sort(pairs.begin(), pairs.end());
  for_each_side_of_surface(*this, [&](Index, Index v, Index w, Index a) {
    if (a != none && std::binary_search(pairs.begin(), pairs.end(), Vertex_pair(std::minmax(v, w))))
      m_flags[a] |= CONSTRAINED;
  });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_COLLECT_ADJACENCIES_H
