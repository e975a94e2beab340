// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MATCH_SIDES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MATCH_SIDES_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/arrays.h>
#include <CGAL/Region_segmentation/internal/surface/Raw_surface.h>

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

/// A side of a face: between two vertices, the lower one first.
struct Side_of_edge
{
  Surface::Index lower_vertex, higher_vertex, face, corner;
  bool is_forward; ///< whether the boundary of the face runs from the lower to the higher vertex
};

/// The side that leaves a corner of a face.
inline Side_of_edge side_at(const Surface_arrays& arrays, Surface::Index face,
                            Surface::Index corner)
{
  const Surface::Index v = arrays.corners[corner],
                       w = arrays.corners[next_corner(arrays, face, corner)];
  return {(std::min)(v, w), (std::max)(v, w), face, corner, v < w};
}

/// Two faces that are adjacent across an edge with more faces, or with neighbors that cannot be
/// oriented.
struct Seam
{
  Surface::Index lower_vertex, higher_vertex;
  Surface::Index face, other_face; ///< the side of `face` has this seam
  double share;                    ///< of the length of the edge
};

/// An open side from or to the lower one of its vertices.
struct Side_at_vertex
{
  Surface::Index other_vertex, face, corner;

  friend bool operator<(const Side_at_vertex& a, const Side_at_vertex& b)
  {
    return std::tie(a.other_vertex, a.corner) < std::tie(b.other_vertex, b.corner);
  }
};

/// Calls `f(sides)` for the open sides between the same two vertices, in order.
template <typename F>
void for_each_open_edge(const Raw_surface& raw, const F& f)
{
  using Index = Surface::Index;
  const Surface_arrays& arrays = arrays_of(raw.surface);
  Grouped_items<Side_at_vertex> by_vertex(arrays.points.size(), [&](const auto& add) {
    for_each_open_side(raw, [&](Index face, Index side, Index next) {
      const Index v = arrays.corners[side], w = arrays.corners[next];
      if (v != w)
        add((std::min)(v, w), {(std::max)(v, w), face, side});
    });
  });
  std::vector<Side_of_edge> of_edge;
  for (std::size_t v = 0; v < by_vertex.number_of_groups(); ++v) {
    const auto sides = by_vertex[v];
    std::sort(sides.begin(), sides.end());
    for (auto side = sides.begin(); side != sides.end();) {
      of_edge.clear();
      for (const Index w = side->other_vertex; side != sides.end() && side->other_vertex == w;
           ++side)
        of_edge.push_back(side_at(arrays, side->face, side->corner));
      f(of_edge);
    }
  }
}

/// Finds what is adjacent across sides with the same two vertices.
///
/// Two sides make an edge. Of more of them, those of degenerate faces are edges to the first of the
/// others; the others make seams, in the cyclic order of the directions in which their faces leave
/// the edge, unless there are only two.
class Side_matcher
{
  using Index = Surface::Index;

public:
  explicit Side_matcher(Raw_surface& raw)
    : m_raw(raw)
    , m_arrays(arrays_of(raw.surface))
  {}

  /// Sets the neighbors of open sides, and collects the seams.
  void match()
  {
    for_each_open_edge(m_raw, [&](const std::vector<Side_of_edge>& sides) { match_edge(sides); });
  }

  /// The sides of edges whose two sides run in the same direction: one of the faces is to be
  /// turned.
  const std::vector<Index>& parallel_sides() const { return m_parallel; }
  const std::vector<Seam>& seams() const { return m_seams; }

private:
  /// `sides`: of the edge, in order
  void match_edge(const std::vector<Side_of_edge>& sides)
  {
    if (sides.size() == 2)
      return join(sides[0], sides[1]);
    m_proper.clear();
    for (const Side_of_edge& s : sides)
      if (!m_raw.surface.is_degenerate(s.face))
        m_proper.push_back(s);
    const Side_of_edge base = m_proper.empty() ? sides.front() : m_proper.front();
    for (const Side_of_edge& s : sides)
      if (s.corner != base.corner && m_raw.surface.is_degenerate(s.face) && s.face != base.face)
        add_seam(s, base, 1);
    if (m_proper.size() == 2)
      join(m_proper[0], m_proper[1]);
    else if (m_proper.size() > 2)
      sew();
  }

  void join(const Side_of_edge& a, const Side_of_edge& b)
  {
    if (a.face == b.face)
      return;
    m_raw.neighbors[a.corner] = b.face;
    m_raw.neighbors[b.corner] = a.face;
    if (a.is_forward == b.is_forward)
      m_parallel.insert(m_parallel.end(), {a.corner, b.corner});
  }

  /// Seams between the proper sides, each to the next one around the edge.
  void sew()
  {
    const Double_3 axis = m_arrays.points[m_proper[0].higher_vertex] -
                          m_arrays.points[m_proper[0].lower_vertex];
    const Double_3 first = inward(m_proper[0], axis),
                   second = (1 / norm(axis)) * cross(axis, first);
    std::vector<std::pair<double, Index>> around;
    for (Index i = 0; i < m_proper.size(); ++i) {
      const Double_3 d = inward(m_proper[i], axis);
      around.push_back({i == 0 ? 0 : pseudo_angle(dot(d, first), dot(d, second)), i});
    }
    std::sort(around.data(), around.data() + around.size());
    for (std::size_t i = 0; i < around.size(); ++i) {
      const Side_of_edge &a = m_proper[around[i].second],
                         &b = m_proper[around[(i + 1) % around.size()].second];
      if (a.face != b.face)
        add_seam(a, b, 0.5);
    }
  }

  void add_seam(const Side_of_edge& a, const Side_of_edge& b, double share)
  {
    m_raw.neighbors[a.corner] = m_raw.neighbors[b.corner] = Raw_surface::at_seam;
    m_seams.push_back({a.lower_vertex, a.higher_vertex, a.face, b.face, share});
  }

  /// The direction from an edge into its face, perpendicular to the edge.
  Double_3 inward(const Side_of_edge& s, const Double_3& axis) const
  {
    return cross(m_arrays.normals[s.face], (s.is_forward ? 1.0 : -1.0) * axis);
  }

  /// Grows with the angle of (x, y), from 0 to 4.
  static double pseudo_angle(double x, double y)
  {
    const double share = y / (std::abs(x) + std::abs(y));
    return x < 0 ? 2 - share : y < 0 ? 4 + share : share;
  }

  Raw_surface& m_raw;
  Surface_arrays& m_arrays;
  std::vector<Side_of_edge> m_proper; // of an edge
  std::vector<Index> m_parallel;
  std::vector<Seam> m_seams;
};

/// For each point that counts the lowest one equal to it, of those; -0 is 0. For each other one
/// itself. Empty if all are different.
inline std::vector<Surface::Index> lowest_of_equal_points(const Large_array<Double_3>& points,
                                                          Function_ref<bool(std::size_t)> counts)
{
  using Index = Surface::Index;
  const auto coordinates = [&](Index v) {
    return std::array{points[v].x + 0.0, points[v].y + 0.0, points[v].z + 0.0};
  };
  std::vector<Index> lowest;
  for_each_repetition(
    points.size(),
    [&](const auto& add) {
      for (Index v = 0; v < points.size(); ++v)
        if (counts(v))
          add(v, boost::hash<std::array<double, 3>>()(coordinates(v)));
    },
    [&](Index v, Index w) { return coordinates(v) == coordinates(w); },
    [&](Index v, Index first) {
      if (lowest.empty()) {
        lowest.resize(points.size());
        std::iota(lowest.begin(), lowest.end(), Index(0));
      }
      lowest[v] = first;
    });
  return lowest;
}

/// Makes equal points one vertex, the lowest, as far as they are at open sides that do not make an
/// edge of two faces: so closed components keep their vertices, of a face graph and of polygons.
inline void merge_points_of_open_sides(Raw_surface& raw)
{
  using Index = Surface::Index;
  Surface_arrays& arrays = arrays_of(raw.surface);
  std::vector<bool> is_at_open_side(arrays.points.size());
  for_each_open_edge(raw, [&](const std::vector<Side_of_edge>& sides) {
    if (sides.size() != 2)
      is_at_open_side[sides[0].lower_vertex] = is_at_open_side[sides[0].higher_vertex] = true;
  });
  const std::vector<Index> lowest = lowest_of_equal_points(
    arrays.points, [&](std::size_t v) { return is_at_open_side[v]; });
  if (lowest.empty())
    return;
  for (Index& v : arrays.corners)
    v = lowest[v];
  begin_at_lowest_vertices(raw, Execution());
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MATCH_SIDES_H
