// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENTS_INTERNAL_SEGMENT_CAPS_H
#define CGAL_REGION_SEGMENTATION_SEGMENTS_INTERNAL_SEGMENT_CAPS_H

#include <CGAL/Region_segmentation/Graph/Region_shapes.h>
#include <CGAL/Region_segmentation/Segments/internal/Segmented_mesh.h>
#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Support/Large_array.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>
#include <CGAL/Region_segmentation/Surface/internal/components.h>

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
  Segmented_halfedges::Index lower, higher;
  std::array<Segmented_halfedges::Index, 3> corners;
};

/// The surfaces that separate the segments inside a mesh, see `close_segments()`. The faces without
/// a segment are one more segment, and what is beyond the border of the mesh is another one.
///
/// The border edges between segments a < b, directed with a to the left, are a flow of the pair (a,
/// b). A vertex where a flow is not conserved is a *junction*: three or more segments meet there.
/// With inner edges between the junctions and the *center* of a network all flows are conserved, so
/// the edges of each pair make closed polygons. A polygon is filled with the triangles between its
/// sides and its center of mass.
class Segment_caps
{
public:
  using Index = Segmented_halfedges::Index;
  using Points = Large_array<Double_3>;

  /// `surface`: has the points of the vertices of the mesh
  /// `is_turned(face)`: whether the corners of a face are taken in reverse order
  template <typename IsTurned>
  Segment_caps(const Segmented_halfedges& mesh, const Surface& surface, const IsTurned& is_turned)
  {
    for (std::size_t v = 0; v < mesh.number_of_vertices; ++v)
      m_points.push_back(surface.point(v));
    for (Index h = 0; h < mesh.size(); ++h)
      if (const Pair pair(mesh.segment(h), mesh.segment_across(h)); pair.first < pair.second) {
        const bool is_swapped = is_turned(mesh.face[h]);
        m_edges[pair].emplace(is_swapped ? mesh.target(h) : mesh.source[h],
                              is_swapped ? mesh.source[h] : mesh.target(h));
      }
    join_junctions();
    for (auto& [pair, edges] : m_edges)
      trace_polygons(pair, edges);
  }

  const std::vector<Cap_triangle>& triangles() const { return m_triangles; }
  /// The points of the vertices of the mesh, then of those that only caps have.
  const Points& points() const { return m_points; }

private:
  using Pair = std::pair<Index, Index>;      // of segments
  using Edges = std::multimap<Index, Index>; // from a vertex to a vertex

  void add_edge(Index from, Index to, Second_moments& moments) const
  {
    // An edge of length 0 has a small weight, so that the center of mass of such edges is defined.
    moments.add(norm(m_points[to] - m_points[from]) + 1e-200,
                0.5 * (m_points[from] + m_points[to]));
  }

  Index add_point(const Double_3& point)
  {
    m_points.push_back(point);
    return Index(m_points.size() - 1);
  }

  /// Adds a center to each network of border edges with junctions, and the inner edges to it.
  void join_junctions()
  {
    // The number of edges of a pair that leave a vertex less the number of those that arrive.
    std::map<std::pair<Index, Pair>, std::ptrdiff_t> excess;
    Lowest_root_forest networks(m_points.size());
    for (const auto& [pair, edges] : m_edges)
      for (const auto& [from, to] : edges) {
        ++excess[{from, pair}];
        --excess[{to, pair}];
        networks.unite(from, to);
      }
    std::map<Index, Second_moments> moments; // by network
    for (const auto& [pair, edges] : m_edges)
      for (const auto& [from, to] : edges)
        add_edge(from, to, moments[networks.root(from)]);
    std::map<Index, Index> centers; // by network
    for (const auto& [place, number] : excess) {
      const auto& [v, pair] = place;
      if (number != 0 && centers.count(networks.root(v)) == 0)
        centers[networks.root(v)] = add_point(moments[networks.root(v)].centroid());
      for (std::ptrdiff_t i = 0; i < number; ++i)
        m_edges[pair].emplace(centers[networks.root(v)], v);
      for (std::ptrdiff_t i = number; i < 0; ++i)
        m_edges[pair].emplace(v, centers[networks.root(v)]);
    }
  }

  /// Follows the edges of a pair, and fills a part of the way that comes back to a vertex.
  void trace_polygons(const Pair& pair, Edges& edges)
  {
    std::map<Index, std::size_t> places; // on the way
    std::vector<Index> way;
    while (!edges.empty()) {
      if (way.empty() || edges.count(way.back()) == 0) { // all edges of this way are in polygons,
                                                         // since flows are conserved
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
      fill(pair, {start, way.end()});
      for (auto i = start + 1; i != way.end(); ++i)
        places.erase(*i);
      way.erase(start + 1, way.end());
    }
  }

  void fill(const Pair& pair, const std::vector<Index>& polygon)
  {
    const std::size_t n = polygon.size();
    if (n < 3)
      return; // the two sides of the polygon coincide
    Index middle = polygon[0];
    if (n > 3) {
      Second_moments moments;
      for (std::size_t i = 0; i < n; ++i)
        add_edge(polygon[i], polygon[(i + 1) % n], moments);
      middle = add_point(moments.centroid());
    }
    for (std::size_t i = 0; i < n; ++i)
      if (const Index from = polygon[i], to = polygon[(i + 1) % n]; from != middle && to != middle)
        m_triangles.push_back({pair.first, pair.second, {to, from, middle}});
  }

  Points m_points;
  std::map<Pair, Edges> m_edges;
  std::vector<Cap_triangle> m_triangles;
};

/// The halfedges of the segments of a mesh, each with its caps: no segment has a border. The first
/// faces, halfedges and vertices are those of the mesh; faces 2 t and 2 t + 1 after them are the
/// two sides of the cap triangle t.
inline Segmented_halfedges with_caps(Segmented_halfedges mesh, const Segment_caps& caps)
{
  using Index = Segmented_halfedges::Index;
  const std::size_t first_of_caps = mesh.size();
  mesh.number_of_vertices = caps.points().size();
  const auto add_side = [&](Index segment, const std::array<Index, 3>& corners) {
    mesh.segment_of_face.push_back(segment);
    mesh.source.insert(mesh.source.end(), corners.begin(), corners.end());
    mesh.add_face();
  };
  for (const Cap_triangle& t : caps.triangles()) {
    add_side(t.lower, t.corners);
    add_side(t.higher, {t.corners[0], t.corners[2], t.corners[1]});
  }
  mesh.opposite.resize(mesh.size(), mesh.none);
  // A halfedge on a border or of a cap, and one of its segment in the other direction, are
  // opposite.
  std::multimap<std::tuple<Index, Index, Index>, Index> waiting; // by segment, source and target
  for (Index h = 0; h < mesh.size(); ++h) {
    if (!mesh.has_segment(h) || (h < first_of_caps && !mesh.is_on_border(h)))
      continue;
    const Index segment = mesh.segment(h), from = mesh.source[h], to = mesh.target(h);
    const auto twin = waiting.find({segment, to, from});
    if (twin == waiting.end()) {
      waiting.emplace(std::make_tuple(segment, from, to), h);
      continue;
    }
    mesh.opposite[h] = twin->second;
    mesh.opposite[twin->second] = h;
    waiting.erase(twin);
  }
  return mesh;
}

/// The volume of each segment with its caps, and at the end that of the faces without a segment.
/// They add up to the volume of the mesh.
///
/// By the divergence theorem, a volume is the sum of the tetrahedra from any point to the triangles
/// of the surface.
inline std::vector<double> segment_volumes(const Segmented_halfedges& mesh, const Surface& surface)
{
  using Index = Segmented_halfedges::Index;
  const Segment_caps caps(mesh, surface, [&](Index f) { return is_turned(surface, mesh, f); });
  const auto& points = caps.points();
  std::vector<double> volumes(mesh.number_of_segments + 2, 0);
  const auto add = [&](Index segment, Index a, Index b, Index c) {
    const Double_3& p = points[a];
    volumes[segment] += dot(p - points[0], cross(points[b] - p, points[c] - p)) / 6;
  };
  for (Index f = 0; f < surface.number_of_faces(); ++f)
    for (std::size_t i = 2; i < surface.number_of_corners(f); ++i)
      add(mesh.segment_of_face[f], surface.corner(f, 0), surface.corner(f, i - 1),
          surface.corner(f, i));
  for (const auto& [lower, higher, corners] : caps.triangles()) {
    add(lower, corners[0], corners[1], corners[2]);
    add(higher, corners[0], corners[2], corners[1]);
  }
  volumes.pop_back(); // that of what is beyond the border of the mesh
  return volumes;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SEGMENTS_INTERNAL_SEGMENT_CAPS_H
