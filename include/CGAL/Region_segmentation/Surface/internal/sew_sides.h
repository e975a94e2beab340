// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_SEW_SIDES_H
#define CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_SEW_SIDES_H

#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/Box_tree.h>
#include <CGAL/Region_segmentation/Surface/internal/Surface_builder.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
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
  // Through references to the arrays it takes twice as long.
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

/// An open side. Open sides are grouped by their lower vertex.
struct Open_side
{
  Surface::Index higher_vertex, face, corner;
};

/// Calls `f(v, sides)` for each pair of vertices with open sides between them: `v` is the lower
/// vertex, `sides` the open sides in the order of their corners.
template <typename F>
void Surface_builder::for_each_open_edge(const F& f) const
{
  Grouped_items<Open_side> by_vertex(m_points.size(), [&](const auto& add) {
    for (Index face = 0; face < number_of_faces(); ++face)
      for (Index side = m_first_corners[face]; side < m_first_corners[face + 1]; ++side)
        if (m_neighbors[side] == none) {
          const auto [v, w] = std::minmax(m_corners[side], m_corners[next_corner(face, side)]);
          if (v != w)
            add(v, {w, face, side});
        }
  });
  for (Index v = 0; v < by_vertex.number_of_groups(); ++v) {
    const auto sides = by_vertex[v];
    std::sort(sides.begin(), sides.end(), [](const Open_side& a, const Open_side& b) {
      return std::tie(a.higher_vertex, a.corner) < std::tie(b.higher_vertex, b.corner);
    });
    for (auto first = sides.begin(), last = first; first != sides.end(); first = last) {
      last = std::find_if(first, sides.end(), [w = first->higher_vertex](const Open_side& s) {
        return s.higher_vertex != w;
      });
      f(v, make_range(first, last));
    }
  }
}

/// By vertex, the length of the shortest open side at it that does not make an edge of two faces;
/// infinite if there is none.
inline std::vector<double> Surface_builder::shortest_open_sides() const
{
  std::vector<double> result(m_points.size(), std::numeric_limits<double>::infinity());
  for_each_open_edge([&](Index v, const auto& sides) {
    const Index w = sides.begin()->higher_vertex;
    if (sides.size() != 2)
      for (const Index at : {v, w})
        result[at] = (std::min)(result[at], norm(m_points[w] - m_points[v]));
  });
  return result;
}

/// Unites vertices at open sides whose points are equal. Returns how many there are less.
/// `open_sides`: by vertex, see `shortest_open_sides()`
inline std::size_t unite_equal_points(const Surface& surface, const std::vector<double>& open_sides,
                                      Lowest_root_forest& merged)
{
  using Index = Surface::Index;
  const auto coordinates = [&](Index v) { // -0 becomes 0
    const Double_3& p = surface.point(v);
    return std::array{p.x + 0.0, p.y + 0.0, p.z + 0.0};
  };
  std::size_t number = 0;
  for_each_repetition(
    open_sides.size(),
    [&](const auto& add) {
      for (Index v = 0; v < open_sides.size(); ++v)
        if (std::isfinite(open_sides[v]))
          add(v, boost::hash<std::array<double, 3>>()(coordinates(v)));
    },
    [&](Index v, Index w) { return coordinates(v) == coordinates(w); },
    [&](Index v, Index first) { number += merged.unite(v, first); });
  return number;
}

/// Unites vertices at open sides whose coordinates differ by at most the tolerance of either
/// vertex: the distance of two numbers of single precision at the largest coordinate, twice, but at
/// most a tenth of the shortest open side at the vertex, so that no side vanishes. Returns how many
/// there are less.
inline std::size_t unite_near_points(const Surface& surface, const std::vector<double>& open_sides,
                                     double largest_coordinate, Lowest_root_forest& merged)
{
  using Index = Surface::Index;
  constexpr double rounding = 0x1p-22, share_of_side = 0.1;
  std::vector<Index> vertices;
  for (Index v = 0; v < open_sides.size(); ++v)
    if (std::isfinite(open_sides[v]))
      vertices.push_back(v);
  std::size_t number = 0;
  if (vertices.empty())
    return number;
  const auto tolerance = [&](Index v) {
    return (std::min)(rounding * largest_coordinate, share_of_side * open_sides[v]);
  };
  const Double_3 origin = surface.point(vertices[0]);
  const auto box = [&](Index v) { return box_of(std::array{surface.point(v) - origin}); };
  const Box_tree tree(vertices.size(), [&](Index i) { return box(vertices[i]); });
  for (const Index v : vertices) {
    const double bound = 4 * tolerance(v) * tolerance(v);
    tree.search([&, at = box(v)](Index node) { return squared_gap(tree.box(node), at); }, bound,
                [&](Index leaf) {
                  const Index w = vertices[tree.item(leaf)];
                  const Double_3 apart = surface.point(w) - surface.point(v);
                  if ((std::max)({std::abs(apart.x), std::abs(apart.y), std::abs(apart.z)}) <=
                      (std::min)(tolerance(v), tolerance(w)))
                    number += merged.unite(v, w);
                });
  }
  return number;
}

/// Merges vertices at open sides, each with the lowest one of its set: those at equal points, then,
/// of those whose sides still do not make an edge of two faces, those at points that differ by
/// rounding. So closed components keep their vertices, of a face graph and of polygons.
inline void Surface_builder::merge_vertices_of_open_sides()
{
  Lowest_root_forest merged(m_points.size());
  const auto use_merged = [&](std::size_t number) {
    for (std::size_t c = 0; c < m_corners.size() && number > 0; ++c)
      m_corners[c] = merged.root(m_corners[c]);
    return number;
  };
  std::vector<double> open_sides = shortest_open_sides();
  const std::size_t equal = use_merged(unite_equal_points(*this, open_sides, merged));
  if (equal > 0)
    open_sides = shortest_open_sides();
  m_number_apart = use_merged(unite_near_points(*this, open_sides, m_largest_coordinate, merged));
  if (equal + m_number_apart == 0)
    return;
  begin_at_lowest_vertices(Execution());
  for (Index v = 0; v < m_points.size(); ++v)
    m_merged_vertices.push_back(merged.root(v));
}

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

/// Makes a face degenerate whose sides are those of a lower face, and gives it an adjacency to that
/// face alone. Only faces with open sides are looked at. O(n log n) for n of them.
inline void Surface_builder::separate_doubled_faces()
{
  const auto key = [&](Index f) { // is independent of the order of the sides
    std::size_t sum = 0;
    for_each_side(*this, f, [&](Index v, Index w) {
      sum += boost::hash<std::pair<Index, Index>>()(std::minmax(v, w));
    });
    return sum;
  };
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
      separate_from_neighbors(f);
      m_normals[f] = {0, 0, 0};
      m_areas[f] = 0;
      m_added.push_back({first, f, m_areas[first], 0}); // some length in the unit of the surface
    });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_SEW_SIDES_H
