// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/Face_matching.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

namespace segment_mesh {

namespace {

using Polygon = Polygon_soup::Polygon;

constexpr std::size_t none = std::size_t(-1);

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Search_traits = CGAL::Search_traits_3<Kernel>;
using Search = CGAL::Orthogonal_k_neighbor_search<Search_traits>;

Kernel::Point_3 to_point_3(const Point& p)
{
  return Kernel::Point_3(p[0], p[1], p[2]);
}

/// The first index of each point of `soup` with the same coordinates.
using First_index = std::map<Point, std::size_t>;

First_index first_indices(const Polygon_soup& soup)
{
  First_index first;
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    first.emplace(soup.points[i], i);
  return first;
}

/// The faces of the mesh, found by the points of the file.
class Mesh_faces
{
public:
  /// `polygons`: the faces of `mesh_soup` with the points of the file
  Mesh_faces(const Polygon_soup& mesh_soup, Polygons polygons)
      : m_mesh_soup(mesh_soup), m_polygons(std::move(polygons))
  {
    for (std::size_t f = 0; f < m_polygons.size(); ++f) {
      m_by_points.emplace(as_set(m_polygons[f]), f);
      for (std::size_t i = 0; i < m_polygons[f].size(); ++i) {
        m_by_edge.emplace(edge(m_polygons[f], i), f);
        m_by_point.emplace(m_polygons[f][i], f);
      }
    }
  }

  std::size_t same_face(const Polygon& polygon) const
  {
    return find(m_by_points, as_set(polygon));
  }

  std::size_t neighbor(const Polygon& polygon, const Point& center)
  {
    for (std::size_t i = 0; i < polygon.size(); ++i)
      if (const std::size_t f = find(m_by_edge, edge(polygon, i)); f != none)
        return f;
    for (std::size_t p : polygon)
      if (const std::size_t f = find(m_by_point, p); f != none)
        return f;
    return nearest(center);
  }

private:
  using Points = std::vector<std::size_t>;

  static Points as_set(const Polygon& polygon)
  {
    Points points(polygon.begin(), polygon.end());
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
  }

  static Vertex_pair edge(const Polygon& polygon, std::size_t i)
  {
    const std::size_t a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    return {(std::min)(a, b), (std::max)(a, b)};
  }

  template <typename Map>
  static std::size_t find(const Map& map, const typename Map::key_type& key)
  {
    const auto found = map.find(key);
    return found == map.end() ? none : found->second;
  }

  std::size_t nearest(const Point& center)
  {
    if (!m_tree) {
      for (std::size_t f = 0; f < m_polygons.size(); ++f)
        m_by_centroid.emplace(to_point_3(centroid(m_mesh_soup, m_mesh_soup.polygons[f])), f);
      m_tree = std::make_unique<Search::Tree>();
      for (const auto& entry : m_by_centroid)
        m_tree->insert(entry.first);
    }
    const Search search(*m_tree, to_point_3(center), 1);
    // Squared distances between huge coordinates overflow, and then none is the nearest.
    return search.begin() == search.end() ? 0 : m_by_centroid.at(search.begin()->first);
  }

  const Polygon_soup& m_mesh_soup;
  Polygons m_polygons;
  std::map<Points, std::size_t> m_by_points;
  std::map<Vertex_pair, std::size_t> m_by_edge;
  std::map<std::size_t, std::size_t> m_by_point;
  std::map<Kernel::Point_3, std::size_t> m_by_centroid;
  std::unique_ptr<Search::Tree> m_tree;
};

} // namespace

Face_matching match_faces(const Polygon_soup& soup, const Polygon_soup& mesh_soup)
{
  Face_matching matching;
  const First_index first = first_indices(soup);
  for (const Point& p : mesh_soup.points)
    matching.point_of_mesh_point.push_back(first.at(p));
  Polygons with_points_of_file = mesh_soup.polygons;
  with_points_of_file.renumber([&](std::size_t i) { return matching.point_of_mesh_point[i]; });
  Mesh_faces mesh_faces(mesh_soup, std::move(with_points_of_file));

  Polygons merged = soup.polygons;
  merged.renumber([&](std::size_t i) { return first.at(soup.points[i]); });
  std::vector<bool> is_taken(mesh_soup.polygons.size(), false);
  for (std::size_t i = 0; i < merged.size(); ++i) {
    std::size_t f = mesh_faces.same_face(merged[i]);
    if (f == none || is_taken[f])
      ++matching.number_of_dropped_faces;
    if (f == none)
      f = mesh_faces.neighbor(merged[i], centroid(soup, soup.polygons[i]));
    else
      is_taken[f] = true;
    matching.mesh_face_of_face.push_back(f);
  }
  return matching;
}

} // namespace segment_mesh
