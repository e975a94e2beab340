// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_MATCH_SIDES_H
#define CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_MATCH_SIDES_H

#include <CGAL/Region_segmentation/Support/Execution.h>
#include <CGAL/Region_segmentation/Support/internal/arrays.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/collect_adjacencies.h>
#include <CGAL/Region_segmentation/Surface/internal/read_surface.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A side whose neighbor is not known. Open sides are grouped by their lower vertex.
struct Open_side
{
  Surface::Index higher_vertex, face, corner;
};

/// Calls `f(v, sides)` for each pair of vertices with open sides between them: `v` is the lower
/// vertex, `sides` the open sides in the order of their corners.
template <typename F>
void for_each_open_edge(const Raw_surface& raw, const F& f)
{
  using Index = Surface::Index;
  const Surface_arrays& arrays = arrays_of(raw.surface);
  Grouped_items<Open_side> by_vertex(arrays.points.size(), [&](const auto& add) {
    for (Index face = 0; face + 1 < arrays.first_corners.size(); ++face)
      for (Index side = arrays.first_corners[face]; side < arrays.first_corners[face + 1]; ++side)
        if (raw.neighbors[side] == Raw_surface::none) {
          const auto [v, w] = std::minmax(arrays.corners[side],
                                          arrays.corners[next_corner(arrays, face, side)]);
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

/// Finds what is adjacent across open sides with the same two vertices.
///
/// Two sides make an edge. Where there are more, each side of a degenerate face makes an edge with
/// the first side of a proper face; the sides of proper faces make seams, in the cyclic order of
/// the directions in which their faces leave the edge, unless there are only two.
class Side_matcher
{
  using Index = Surface::Index;

public:
  explicit Side_matcher(Raw_surface& raw, std::vector<Added_adjacency>& added)
    : m_raw(raw)
    , m_arrays(arrays_of(raw.surface))
    , m_added(added)
    , m_is_parallel(m_arrays.corners.size())
  {}

  /// Sets the neighbors of open sides, and adds seams. Returns for each side whether that of its
  /// neighbor runs in the same direction, so that one of their faces is to be turned.
  std::vector<bool> match()
  {
    for_each_open_edge(m_raw, [&](Index v, const auto& sides) {
      const auto number = sides.end() - sides.begin();
      number == 2 ? join(sides.begin()[0], sides.begin()[1]) : match_sides(v, sides);
    });
    return std::move(m_is_parallel);
  }

private:
  template <typename Sides>
  void match_sides(Index v, const Sides& sides)
  {
    m_proper.clear();
    for (const Open_side& s : sides)
      if (!m_raw.surface.is_degenerate(s.face))
        m_proper.push_back(s);
    const Open_side base = m_proper.empty() ? *sides.begin() : m_proper.front();
    for (const Open_side& s : sides)
      if (m_raw.surface.is_degenerate(s.face) && s.face != base.face)
        add_seam(v, s, base, 1);
    if (m_proper.size() == 2)
      join(m_proper[0], m_proper[1]);
    else if (m_proper.size() > 2)
      sew(v);
  }

  void join(const Open_side& a, const Open_side& b)
  {
    if (a.face == b.face)
      return;
    m_raw.neighbors[a.corner] = b.face;
    m_raw.neighbors[b.corner] = a.face;
    m_is_parallel[a.corner] = m_is_parallel[b.corner] = is_forward(a) == is_forward(b);
  }

  /// Seams between the proper sides at the edge from the vertex v, each to the next one around it.
  void sew(Index v)
  {
    const Double_3 axis = m_arrays.points[m_proper[0].higher_vertex] - m_arrays.points[v];
    // The direction from the edge into a face, perpendicular to the edge.
    const auto inward = [&](const Open_side& s) {
      return cross(m_arrays.normals[s.face], (is_forward(s) ? 1.0 : -1.0) * axis);
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
    m_raw.neighbors[a.corner] = m_raw.neighbors[b.corner] = Raw_surface::at_seam;
    m_added.push_back(seam_between(m_raw.surface, a.face, b.face, v, a.higher_vertex, share));
  }

  /// Whether the boundary of the face runs from the lower to the higher vertex.
  bool is_forward(const Open_side& s) const
  {
    return m_arrays.corners[s.corner] != s.higher_vertex;
  }

  /// Grows with the angle of (x, y), from 0 to 4.
  static double pseudo_angle(double x, double y)
  {
    const double share = y / (std::abs(x) + std::abs(y));
    return x < 0 ? 2 - share : y < 0 ? 4 + share : share;
  }

  Raw_surface& m_raw;
  const Surface_arrays& m_arrays;
  std::vector<Added_adjacency>& m_added;
  std::vector<bool> m_is_parallel; // by side
  std::vector<Open_side> m_proper; // the sides at the current edge of proper faces
};

/// Makes equal points one vertex, the lowest, as far as they are at open sides that do not make an
/// edge of two faces: so closed components keep their vertices, of a face graph and of polygons.
inline void merge_points_of_open_sides(Raw_surface& raw)
{
  using Index = Surface::Index;
  Surface_arrays& arrays = arrays_of(raw.surface);
  const std::size_t size = arrays.points.size();
  std::vector<bool> is_at_open_side(size);
  for_each_open_edge(raw, [&](Index v, const auto& sides) {
    if (sides.end() - sides.begin() != 2)
      is_at_open_side[v] = is_at_open_side[sides.begin()->higher_vertex] = true;
  });
  const auto coordinates = [&](Index v) { // -0 becomes 0
    const Double_3& p = arrays.points[v];
    return std::array{p.x + 0.0, p.y + 0.0, p.z + 0.0};
  };
  std::vector<Index>& merged = arrays.merged_vertices;
  for_each_repetition(
    size,
    [&](const auto& add) {
      for (Index v = 0; v < size; ++v)
        if (is_at_open_side[v])
          add(v, boost::hash<std::array<double, 3>>()(coordinates(v)));
    },
    [&](Index v, Index w) { return coordinates(v) == coordinates(w); },
    [&](Index v, Index first) {
      if (merged.empty()) {
        merged.resize(size);
        std::iota(merged.begin(), merged.end(), Index(0));
      }
      merged[v] = first;
    });
  if (merged.empty())
    return;
  for (Index& v : arrays.corners)
    v = merged[v];
  begin_at_lowest_vertices(raw, Execution());
}

/// Lets the sides of a face lead to itself. The sides of its neighbors that led to it become open.
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

/// Makes a face degenerate whose sides are those of a lower face, and gives it an adjacency to that
/// face alone. Only faces with open sides are looked at. O(n log n) for n of them.
inline void find_doubled_faces(Raw_surface& raw, std::vector<Added_adjacency>& added)
{
  using Index = Surface::Index;
  Surface_arrays& arrays = arrays_of(raw.surface);
  const auto key = [&](Index f) { // is independent of the order of the sides
    std::size_t sum = 0;
    for_each_side(raw.surface, f, [&](Index v, Index w) {
      sum += boost::hash<std::pair<Index, Index>>()(std::minmax(v, w));
    });
    return sum;
  };
  for_each_repetition(
    arrays.normals.size(),
    [&](const auto& add) {
      for (Index f = 0; f < arrays.normals.size(); ++f)
        if (const auto sides = raw.neighbors.begin() + arrays.first_corners[f],
            end = raw.neighbors.begin() + arrays.first_corners[f + 1];
            std::find(sides, end, Raw_surface::none) != end)
          add(f, key(f));
    },
    [&](Index f, Index g) {
      const auto a = raw.surface.corners(f), b = raw.surface.corners(g);
      return key(f) == key(g) && std::is_permutation(a.begin(), a.end(), b.begin(), b.end());
    },
    [&](Index f, Index first) {
      separate_from_neighbors(raw, f);
      arrays.normals[f] = {0, 0, 0};
      arrays.areas[f] = 0;
      added.push_back({first, f, arrays.areas[first], 0}); // some length in the unit of the surface
    });
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SURFACE_INTERNAL_MATCH_SIDES_H
