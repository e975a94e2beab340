// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_CAPS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_CAPS_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>
#include <CGAL/Region_segmentation/internal/support/components.h>

#include <array>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// A triangle between two segments, counterclockwise seen from outside that of lower number.
struct Cap_triangle
{
  Halfedge_table::Index lower, higher;
  std::array<Halfedge_table::Index, 3> corners;
};

/// The surfaces that separate the segments inside a mesh, see `close_segments()`. The faces without
/// a segment are one more segment, and what is beyond the border of the mesh is another one.
///
/// The border edges between segments a < b, directed with a to the left, are a flow of the pair (a,
/// b). Where one is not conserved, three or more segments meet: a *junction*. Inner edges between
/// the junctions and the *center* of a network conserve all flows; so the edges of each pair make
/// closed polygons. A polygon is filled with the triangles between its sides and its center of
/// mass.
class Segment_caps
{
public:
  using Index = Halfedge_table::Index;

  /// `points`: by vertex of the mesh. `is_turned(face)`: whether a face is read the other way round
  template <typename IsTurned>
  Segment_caps(const Segmented_halfedges& mesh, std::vector<Double_3> points,
               const IsTurned& is_turned)
    : m_mesh(mesh)
    , m_points(std::move(points))
  {
    collect_border_edges(is_turned);
    join_junctions();
    for (const auto& [pair, edges] : m_edges)
      trace_polygons(pair, edges);
    place_centers();
    for (const Polygon& polygon : m_polygons)
      fill(polygon);
  }

  /// The number of a segment in a cap: that of the faces without one is above all.
  Index numbered(Index segment) const
  {
    return segment == m_mesh.none ? Index(m_mesh.number_of_segments) : segment;
  }

  const std::vector<Cap_triangle>& triangles() const { return m_triangles; }
  /// Of the vertices of the mesh, then of those that the caps have beside.
  const std::vector<Double_3>& points() const { return m_points; }

private:
  using Pair = std::pair<Index, Index>;      // of segments
  using Edges = std::multimap<Index, Index>; // from a vertex to a vertex

  struct Polygon
  {
    Pair pair;
    std::vector<Index> corners;
  };

  /// Of edges.
  struct Center_of_mass
  {
    Double_3 sum{0, 0, 0}, last{0, 0, 0};
    double length = 0;

    void add(const Double_3& from, const Double_3& to)
    {
      sum = sum + 0.5 * norm(to - from) * (from + to);
      length += norm(to - from);
      last = to;
    }
    Double_3 position() const { return length > 0 ? 1 / length * sum : last; }
  };

  Index numbered_across(Index h) const
  {
    return m_mesh.opposite[h] == m_mesh.none ? Index(m_mesh.number_of_segments + 1)
                                             : numbered(m_mesh.segment_across(h));
  }

  template <typename IsTurned>
  void collect_border_edges(const IsTurned& is_turned)
  {
    for (Index h = 0; h < m_mesh.size(); ++h)
      if (const Pair pair(numbered(m_mesh.segment(h)), numbered_across(h));
          pair.first < pair.second) {
        Index from = m_mesh.source[h], to = m_mesh.target(h);
        if (is_turned(m_mesh.face[h]))
          std::swap(from, to);
        m_edges[pair].emplace(from, to);
      }
  }

  /// By a center for each network of border edges with junctions.
  void join_junctions()
  {
    std::map<std::pair<Index, Pair>, std::ptrdiff_t> excess; // what leaves a vertex less what
                                                             // arrives
    Lowest_root_forest networks(m_mesh.number_of_vertices);
    for (const auto& [pair, edges] : m_edges)
      for (const auto& [from, to] : edges) {
        ++excess[{from, pair}];
        --excess[{to, pair}];
        networks.unite(from, to);
      }
    std::map<Index, Index> centers; // by network
    for (const auto& [place, number] : excess) {
      if (number == 0)
        continue;
      const auto& [v, pair] = place;
      const auto [center, is_new] = centers.emplace(networks.root(v), Index(m_points.size()));
      if (is_new)
        add_center();
      for (std::ptrdiff_t i = 0; i < number; ++i)
        m_edges[pair].emplace(center->second, v);
      for (std::ptrdiff_t i = number; i < 0; ++i)
        m_edges[pair].emplace(v, center->second);
    }
  }

  Index add_center()
  {
    m_points.push_back({0, 0, 0});
    return Index(m_points.size() - 1);
  }

  /// Follows the edges of a pair; a part of the way that comes back to a vertex is a polygon.
  void trace_polygons(const Pair& pair, Edges edges)
  {
    std::map<Index, std::size_t> places; // on the way
    std::vector<Index> way;
    while (!edges.empty()) {
      if (way.empty() || edges.count(way.back()) == 0) { // done with it: flows are conserved
        way.assign(1, edges.begin()->first);
        places = {{way[0], 0}};
      }
      const auto next = edges.lower_bound(way.back());
      const Index to = next->second;
      edges.erase(next);
      const auto [place, is_new] = places.emplace(to, way.size());
      if (is_new) {
        way.push_back(to);
        continue;
      }
      const auto start = way.begin() + std::ptrdiff_t(place->second);
      m_polygons.push_back({pair, {start, way.end()}});
      for (auto i = start + 1; i != way.end(); ++i)
        places.erase(*i);
      way.erase(start + 1, way.end());
    }
  }

  template <typename F>
  static void for_each_side(const Polygon& polygon, const F& f)
  {
    for (std::size_t i = 0; i < polygon.corners.size(); ++i)
      f(polygon.corners[i], polygon.corners[(i + 1) % polygon.corners.size()]);
  }

  /// A center is that of mass of the border edges of its polygons.
  void place_centers()
  {
    const Index first = Index(m_mesh.number_of_vertices);
    std::vector<Center_of_mass> centers(m_points.size() - first);
    for (const Polygon& polygon : m_polygons)
      for (Index c : polygon.corners)
        if (c >= first)
          for_each_side(polygon, [&](Index from, Index to) {
            if (from < first && to < first)
              centers[c - first].add(m_points[from], m_points[to]);
          });
    for (Index i = 0; i < centers.size(); ++i)
      m_points[first + i] = centers[i].position();
  }

  void fill(const Polygon& polygon)
  {
    const std::size_t n = polygon.corners.size();
    if (n < 3)
      return; // its two sides coincide
    Index middle = polygon.corners[0];
    if (n > 3) {
      Center_of_mass center;
      for_each_side(polygon,
                    [&](Index from, Index to) { center.add(m_points[from], m_points[to]); });
      middle = add_center();
      m_points[middle] = center.position();
    }
    for_each_side(polygon, [&](Index from, Index to) {
      if (from != middle && to != middle)
        m_triangles.push_back({polygon.pair.first, polygon.pair.second, {to, from, middle}});
    });
  }

  const Segmented_halfedges& m_mesh;
  std::vector<Double_3> m_points;
  std::map<Pair, Edges> m_edges;
  std::vector<Polygon> m_polygons;
  std::vector<Cap_triangle> m_triangles;
};

/// The halfedges of the segments of a mesh, each with its caps: no segment has a border. The first
/// halfedges and vertices are those of the mesh, in their order.
class Closed_segments : public Segmented_halfedges
{
public:
  Closed_segments(const Segmented_halfedges& mesh, const Segment_caps& caps)
    : Segmented_halfedges(mesh)
  {
    m_first_of_caps = mesh.number_of_faces();
    number_of_vertices = caps.points().size();
    for (const Cap_triangle& t : caps.triangles()) {
      add_triangle(t.lower, {t.corners[0], t.corners[1], t.corners[2]});
      add_triangle(t.higher, {t.corners[0], t.corners[2], t.corners[1]});
      m_is_inner.push_back(t.higher <= number_of_segments);
    }
    opposite.resize(size(), none);
    link(mesh.size());
  }

  /// Whether a face belongs to a cap between two segments, not to one on the border of the mesh.
  bool is_between_segments(Index f) const
  {
    return f >= m_first_of_caps && m_is_inner[(f - m_first_of_caps) / 2];
  }

private:
  void add_triangle(Index segment, const std::array<Index, 3>& corners)
  {
    segment_of_face.push_back(segment < number_of_segments ? segment : none);
    face.resize(face.size() + 3, Index(number_of_faces()));
    source.insert(source.end(), corners.begin(), corners.end());
    first.push_back(Index(source.size()));
  }

  /// A halfedge on a border or of a cap, and one of its segment in the other direction, are
  /// opposite.
  void link(std::size_t first_of_caps)
  {
    std::map<std::tuple<Index, Index, Index>, std::vector<Index>> waiting; // segment, source,
                                                                           // target
    for (Index h = 0; h < size(); ++h) {
      if (segment(h) == none || (h < first_of_caps && !is_on_border(h)))
        continue;
      const auto twin = waiting.find({segment(h), target(h), source[h]});
      opposite[h] = none;
      if (twin == waiting.end()) {
        waiting[{segment(h), source[h], target(h)}].push_back(h);
        continue;
      }
      opposite[h] = twin->second.back();
      opposite[twin->second.back()] = h;
      twin->second.pop_back();
      if (twin->second.empty())
        waiting.erase(twin);
    }
  }

  std::size_t m_first_of_caps = 0; // faces
  std::vector<bool> m_is_inner;    // by cap triangle
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_CAPS_H
