// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodies.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace mesh_to_step {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

using Polygons = std::vector<std::vector<std::size_t>>;

/// A side of a polygon, from a vertex to the next one.
struct Side
{
  std::size_t polygon, corner, next_corner; ///< corners of all polygons are numbered on
  std::size_t source, target;
};

/// The sides of all polygons, those of an edge together.
std::vector<Side> sides_by_edge(const Polygons& polygons)
{
  std::vector<Side> result;
  std::size_t first = 0;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const std::size_t n = polygons[i].size();
    for (std::size_t c = 0; c < n; ++c)
      result.push_back(
        {i, first + c, first + (c + 1) % n, polygons[i][c], polygons[i][(c + 1) % n]});
    first += n;
  }
  const auto key = [](const Side& s) {
    return std::make_tuple((std::min)(s.source, s.target), (std::max)(s.source, s.target),
                           s.corner);
  };
  std::sort(result.begin(), result.end(),
            [&](const Side& s, const Side& t) { return key(s) < key(t); });
  return result;
}

/// Pairs the sides of polygons at one edge.
class Side_matcher
{
public:
  Side_matcher(const std::vector<Point>& points, const Polygons& polygons)
    : m_points(points)
    , m_polygons(polygons)
  {}

  using Pair = std::pair<const Side*, const Side*>;

  /// Of two sides one pair; of more, pairs of opposite sides, those first that are nearest through
  /// the material.
  std::vector<Pair> pairs(const std::vector<const Side*>& sides) const
  {
    if (sides.size() == 2)
      return {{sides[0], sides[1]}};
    std::vector<std::pair<double, Pair>> candidates;
    for (const Side* s : sides)
      for (const Side* t : sides)
        if (s->source < s->target && t->source > t->target)
          candidates.push_back({angle_through_material(*s, *t), {s, t}});
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Pair> result;
    std::set<const Side*> used;
    for (const auto& [angle, pair] : candidates)
      if (used.count(pair.first) + used.count(pair.second) == 0) {
        result.push_back(pair);
        used.insert({pair.first, pair.second});
      }
    return result;
  }

private:
  /// The angle from the polygon of a side to that of an opposite side, from 0 to a turn, which is
  /// that of the polygons of two bodies that touch.
  double angle_through_material(const Side& s, const Side& t) const
  {
    constexpr double turn = 2 * CGAL_PI, rounding = 1e-4;
    const Kernel::Vector_3 from = direction_into(s), down = -normal(s.polygon),
                           to = direction_into(t);
    const double angle = std::atan2(to * down / std::sqrt(down.squared_length()),
                                    to * from / std::sqrt(from.squared_length()));
    return angle < rounding ? angle + turn : angle;
  }

  /// The direction at a right angle to a side, into the polygon.
  Kernel::Vector_3 direction_into(const Side& s) const
  {
    return CGAL::cross_product(normal(s.polygon), m_points[s.target] - m_points[s.source]);
  }

  Kernel::Vector_3 normal(std::size_t polygon) const
  {
    const std::vector<std::size_t>& p = m_polygons[polygon];
    Kernel::Vector_3 sum = CGAL::NULL_VECTOR;
    for (std::size_t i = 2; i < p.size(); ++i)
      sum += CGAL::cross_product(m_points[p[i - 1]] - m_points[p[0]],
                                 m_points[p[i]] - m_points[p[0]]);
    return sum;
  }

  const std::vector<Point>& m_points;
  const Polygons& m_polygons;
};

/// Merges points that differ by rounding, and drops sides between equal points and polygons that
/// have fewer than three others.
Polygons merged(const std::vector<Point>& points, const Polygons& polygons)
{
  const RS::Surface surface = RS::make_surface_of_polygon_soup(
    points, polygons, RS::parameters::component_links(false));
  Polygons result;
  for (std::vector<std::size_t> polygon : polygons) {
    for (std::size_t& v : polygon)
      v = surface.merged_vertex(v);
    polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
    while (polygon.size() > 1 && polygon.front() == polygon.back())
      polygon.pop_back();
    if (std::set<std::size_t>(polygon.begin(), polygon.end()).size() < polygon.size())
      throw std::invalid_argument("a face meets itself: it has a hole, or crosses itself");
    if (polygon.size() > 2)
      result.push_back(polygon);
  }
  return result;
}

} // namespace

Mesh make_bodies(const std::vector<Point>& points, const Polygons& given_polygons)
{
  Polygons polygons = merged(points, given_polygons);
  const std::vector<Side> sides = sides_by_edge(polygons);
  const Side_matcher matcher(points, polygons);
  boost::disjoint_sets_with_storage<> fans(sides.size()); // of corners: each is a vertex
  for (auto first = sides.begin(); first != sides.end();) {
    std::vector<const Side*> at_edge;
    const auto ends = std::minmax(first->source, first->target);
    for (; first != sides.end() && std::minmax(first->source, first->target) == ends; ++first)
      at_edge.push_back(&*first);
    for (const auto& [s, t] : matcher.pairs(at_edge)) {
      const bool is_opposite = s->source == t->target;
      fans.union_set(s->corner, is_opposite ? t->next_corner : t->corner);
      fans.union_set(s->next_corner, is_opposite ? t->corner : t->next_corner);
    }
  }
  std::map<std::size_t, std::size_t> number;
  std::vector<Point> vertices;
  std::size_t corner = 0;
  for (auto& polygon : polygons)
    for (std::size_t& v : polygon) {
      const auto [found, is_new] = number.emplace(fans.find_set(corner++), vertices.size());
      if (is_new)
        vertices.push_back(points[v]);
      v = found->second;
    }
  PMP::orient_polygon_soup(vertices, polygons);
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(vertices, polygons, mesh);
  PMP::triangulate_faces(mesh);
  return mesh;
}

Bodies orient_bodies(Mesh& mesh)
{
  const RS::Surface surface = RS::make_surface(mesh);
  Bodies result;
  std::map<std::size_t, std::vector<Mesh::Face_index>> components;
  std::vector<double> volumes(surface.number_of_components());
  for (auto f : faces(mesh)) {
    const std::size_t i = result.component.size(), component = surface.components()[i];
    const RS::Surface::Index around = surface.body_around(i);
    result.component.push_back(component);
    result.body.push_back(around == RS::Surface::none ? component : around);
    components[component].push_back(f);
    const auto h = halfedge(f, mesh);
    volumes[component] += CGAL::volume(CGAL::ORIGIN + Kernel::Vector_3(0, 0, 0),
                                       mesh.point(source(h, mesh)), mesh.point(target(h, mesh)),
                                       mesh.point(target(next(h, mesh), mesh)));
  }
  for (const auto& [component, triangles] : components) {
    const bool is_void = result.body[triangles.front()] != component;
    if ((volumes[component] < 0) != is_void)
      PMP::reverse_face_orientations(triangles, mesh);
  }
  return result;
}

} // namespace mesh_to_step
