// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_SEW_SIDES_H
#define CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_SEW_SIDES_H

#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/Surface_builder.h>
#include <CGAL/Region_segmentation/Surface/internal/open_sides.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Finds what is adjacent across open sides with the same two vertices.
///
/// Two sides make an edge. Where there are more, each side of a degenerate face makes an edge with
/// the first side of a proper face; the sides of proper faces make seams, in the cyclic order of
/// the directions in which their faces leave the edge, unless there are only two.
class Surface_builder::Side_matcher
{
public:
  explicit Side_matcher(Surface_builder& builder)
    : m_builder(builder)
  {}

  /// Sets the neighbors of the open sides between two vertices, of which v is the lower one, or
  /// adds seams.
  template <typename Sides>
  void match(Index v, const Sides& sides)
  {
    if (sides.size() == 2)
      return join(sides.begin()[0], sides.begin()[1]);
    if (join_bodies(sides))
      return;
    m_proper.clear();
    for (const Open_side& s : sides)
      if (!m_builder.is_degenerate(s.face))
        m_proper.push_back(s);
    const Open_side base = m_proper.empty() ? *sides.begin() : m_proper.front();
    for (const Open_side& s : sides)
      if (m_builder.is_degenerate(s.face) && s.face != base.face)
        add_seam(v, s, base, 1);
    if (m_proper.size() == 2)
      join(m_proper[0], m_proper[1]);
    else if (m_proper.size() > 2)
      sew(v);
  }

private:
  /// Joins the sides of two bodies that touch: each of two twins with the other side that runs in
  /// the opposite direction. Returns whether there are twins, and one such side for each.
  template <typename Sides>
  bool join_bodies(const Sides& sides)
  {
    if (sides.size() != 4)
      return false;
    for (const Open_side& s : sides)
      for (const Open_side& t : sides) {
        if (!m_builder.are_twins(s.face, t.face))
          continue;
        const Open_side *opposite_to_s = nullptr, *opposite_to_t = nullptr;
        for (const Open_side& u : sides)
          if (u.face != s.face && u.face != t.face)
            (is_forward(u) != is_forward(s) ? opposite_to_s : opposite_to_t) = &u;
        if (!opposite_to_s || !opposite_to_t)
          return false;
        join(s, *opposite_to_s);
        join(t, *opposite_to_t);
        return true;
      }
    return false;
  }

  void join(const Open_side& a, const Open_side& b)
  {
    if (a.face == b.face)
      return;
    m_builder.m_neighbors[a.corner] = b.face;
    m_builder.m_neighbors[b.corner] = a.face;
    m_builder.m_is_parallel[a.corner] = m_builder.m_is_parallel[b.corner] = is_forward(a) ==
                                                                            is_forward(b);
  }

  /// Seams between the proper sides at the edge from the vertex v, each to the next one around it.
  void sew(Index v)
  {
    const Double_3 axis = m_builder.m_points[m_proper[0].higher_vertex] - m_builder.m_points[v];
    // The direction from the edge into a face, perpendicular to the edge.
    const auto inward = [&](const Open_side& s) {
      return cross(m_builder.m_normals[s.face], (is_forward(s) ? 1.0 : -1.0) * axis);
    };
    const Double_3 first = inward(m_proper[0]), second = (1 / norm(axis)) * cross(axis, first);
    std::vector<std::pair<double, Index>> around{{0, 0}};
    for (Index i = 1; i < m_proper.size(); ++i) {
      const Double_3 d = inward(m_proper[i]);
      around.push_back({pseudo_angle(dot(d, first), dot(d, second)), i});
    }
    std::sort(around.begin(), around.end());
    for (std::size_t i = 0; i < around.size(); ++i) {
      const Open_side &a = m_proper[around[i].second],
                      &b = m_proper[around[(i + 1) % around.size()].second];
      if (a.face != b.face)
        add_seam(v, a, b, 0.5);
    }
  }

  void add_seam(Index v, const Open_side& a, const Open_side& b, double share)
  {
    m_builder.m_neighbors[a.corner] = m_builder.m_neighbors[b.corner] = at_seam;
    m_builder.m_added.push_back(m_builder.seam_between(a.face, b.face, v, a.higher_vertex, share));
  }

  /// Whether the boundary of the face runs from the lower to the higher vertex.
  bool is_forward(const Open_side& s) const
  {
    return m_builder.m_corners[s.corner] != s.higher_vertex;
  }

  /// Grows with the angle of (x, y), from 0 to 4; 0 for a vector without direction, as that of a
  /// polygon whose area vector is parallel to the edge.
  static double pseudo_angle(double x, double y)
  {
    const double sum = std::abs(x) + std::abs(y);
    if (!(sum > 0))
      return 0;
    const double share = y / sum;
    return x < 0 ? 2 - share : y < 0 ? 4 + share : share;
  }

  Surface_builder& m_builder;
  std::vector<Open_side> m_proper; // the sides at the current edge of proper faces
};

/// Finds what is adjacent across open sides.
inline void Surface_builder::match_open_sides()
{
  m_is_parallel.assign(m_corners.size(), false);
  Side_matcher matcher(*this);
  for_each_open_edge([&](Index v, const auto& sides) { matcher.match(v, sides); });
}

/// The seam across the side of a face f between the vertices v and w, with a share of its length;
/// an edge if one of the faces is degenerate.
inline Added_adjacency Surface_builder::seam_between(Index f, Index g, Index v, Index w,
                                                     double share) const
{
  const bool is_edge = is_degenerate(f) || is_degenerate(g);
  const double squared_length = share * share * squared_norm(m_points[w] - m_points[v]);
  return {
    (std::min)(f, g), (std::max)(f, g), squared_length, std::uint8_t(is_edge ? 0 : SEAM), f, v, w};
}

/// Lets the sides of a face lead to itself. The sides of its neighbors that led to it become open.
inline void Surface_builder::separate_from_neighbors(Index face)
{
  for (Index side = m_first_corners[face]; side < m_first_corners[face + 1]; ++side) {
    const Index neighbor = m_neighbors[side];
    m_neighbors[side] = face;
    if (!is_face(neighbor) || neighbor == face)
      continue;
    for (Index s = m_first_corners[neighbor]; s < m_first_corners[neighbor + 1]; ++s)
      if (m_neighbors[s] == face)
        m_neighbors[s] = none;
  }
}

/// By side, whether four open sides meet at its edge, two in each direction: as where the sides of
/// two bodies coincide.
inline std::vector<bool> Surface_builder::sides_between_bodies() const
{
  std::vector<bool> result(m_corners.size());
  for_each_open_edge([&](Index v, const auto& sides) {
    const auto is_forward = [&](const Open_side& s) { return m_corners[s.corner] == v; };
    if (sides.size() == 4 && std::count_if(sides.begin(), sides.end(), is_forward) == 2)
      for (const Open_side& s : sides)
        result[s.corner] = true;
  });
  return result;
}

/// Makes a face degenerate whose sides are those of a lower face, and gives it an adjacency to that
/// face alone. Where two bodies touch, so that there are two such faces, which run in opposite
/// directions, and all their sides are between bodies, both remain as twins. Only faces with open
/// sides are looked at. O(n log n) for n of them.
inline void Surface_builder::separate_doubled_faces()
{
  const auto key = [&](Index f) { // is independent of the order of the sides
    std::size_t sum = 0;
    for_each_side(*this, f, [&](Index v, Index w) {
      sum += boost::hash<std::pair<Index, Index>>()(std::minmax(v, w));
    });
    return sum;
  };
  std::vector<std::pair<Index, Index>> doubled; // a face, and the lowest one with its sides
  std::map<Index, std::size_t> numbers;         // of the faces with the sides of a lower one
  for_each_repetition(
    number_of_faces(),
    [&](const auto& add) {
      for (Index f = 0; f < number_of_faces(); ++f)
        if (const auto sides = m_neighbors.begin() + m_first_corners[f],
            end = m_neighbors.begin() + m_first_corners[f + 1];
            std::find(sides, end, none) != end)
          add(f, key(f));
    },
    [&](Index f, Index g) {
      const auto a = corners(f), b = corners(g);
      return key(f) == key(g) && std::is_permutation(a.begin(), a.end(), b.begin(), b.end());
    },
    [&](Index f, Index first) {
      doubled.push_back({f, first});
      ++numbers[first];
    });
  if (doubled.empty())
    return;
  const std::vector<bool> is_between_bodies = sides_between_bodies();
  for (const auto& [f, first] : doubled) {
    const auto sides = is_between_bodies.begin() + m_first_corners[f],
               end = is_between_bodies.begin() + m_first_corners[f + 1];
    if (numbers[first] == 1 && std::find(sides, end, false) == end &&
        corner(f, 1) == corner(first, number_of_corners(first) - 1)) {
      m_twins[f] = first;
      m_twins[first] = f;
      continue;
    }
    separate_from_neighbors(f);
    m_normals[f] = {0, 0, 0};
    m_areas[f] = 0;
    m_added.push_back({first, f, m_areas[first], 0}); // some length in the unit of the surface
  }
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_SEW_SIDES_H
