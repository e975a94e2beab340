// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/Manifold.h"

#include "soup/link_corners.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <vector>

namespace segment_mesh {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

using Point_3 = Manifold::Mesh::Point;

/// Whether any two points of a range are different.
bool are_different(std::vector<Point> points)
{
  std::sort(points.begin(), points.end());
  return std::adjacent_find(points.begin(), points.end()) == points.end();
}

/// The mesh of a soup that is an oriented 2-manifold.
Manifold of_manifold(const Polygon_soup& soup)
{
  Manifold result;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, result.mesh);
  result.face_of_mesh_face.resize(soup.polygons.size());
  std::iota(result.face_of_mesh_face.begin(), result.face_of_mesh_face.end(), std::size_t(0));
  result.point_of_mesh_point.resize(soup.points.size());
  std::iota(result.point_of_mesh_point.begin(), result.point_of_mesh_point.end(), std::size_t(0));
  return result;
}

/// Polygons with equal points merged, and points that they use. A polygon that comes back to a
/// point, as around a hole that a bridge joins to its boundary, gets a copy of it.
class Repair
{
public:
  explicit Repair(const Polygon_soup& soup)
    : m_soup(soup)
  {}

  Manifold run()
  {
    for (std::size_t f = 0; f < m_soup.polygons.size(); ++f) {
      const std::vector<std::size_t> corners = corners_of(m_soup.polygons[f]);
      if (corners.size() < 3)
        continue;
      m_polygons.push_back(corners);
      m_result.face_of_mesh_face.push_back(f);
    }
    PMP::orient_polygon_soup(m_points, m_polygons); // keeps the order of the faces
    PMP::polygon_soup_to_polygon_mesh(m_points, m_polygons, m_result.mesh);
    for (const auto v : m_result.mesh.vertices()) {
      const Point_3& p = m_result.mesh.point(v);
      m_result.point_of_mesh_point.push_back(m_first.at({p.x(), p.y(), p.z()})[1]);
    }
    return std::move(m_result);
  }

private:
  /// The merged points at the corners; none if fewer than three are different.
  template <typename Polygon>
  std::vector<std::size_t> corners_of(const Polygon& polygon)
  {
    const auto point = [&](std::size_t i) -> const Point& { return m_soup.points[i]; };
    std::vector<std::size_t> ends; // of sides that are no points
    std::set<Point> different;
    for (std::size_t i : polygon)
      if (ends.empty() || point(ends.back()) != point(i))
        ends.push_back(i);
    while (ends.size() > 1 && point(ends.front()) == point(ends.back()))
      ends.pop_back();
    for (std::size_t i : ends)
      different.insert(point(i));
    std::vector<std::size_t> corners;
    std::set<std::size_t> visited;
    for (std::size_t i = 0; i < ends.size() && different.size() > 2; ++i) {
      const std::size_t corner = index_of(ends[i]);
      const bool comes_back = !visited.insert(corner).second;
      corners.push_back(comes_back ? m_points.size() : corner);
      if (comes_back)
        m_points.push_back(m_points[corner]);
    }
    return corners;
  }

  std::size_t index_of(std::size_t point)
  {
    const Point& p = m_soup.points[point];
    const auto [found, is_new] = m_first.emplace(p, Vertex_pair{m_points.size(), point});
    if (is_new)
      m_points.emplace_back(p[0], p[1], p[2]);
    return found->second[0];
  }

  const Polygon_soup& m_soup;
  std::map<Point, Vertex_pair> m_first; // by coordinates: the merged point, and the first one of
                                        // the soup
  std::vector<Point_3> m_points;
  std::vector<std::vector<std::size_t>> m_polygons;
  Manifold m_result;
};

} // namespace

Manifold make_manifold(const Polygon_soup& soup)
{
  return is_oriented_manifold(soup) && are_different({soup.points.begin(), soup.points.end()})
           ? of_manifold(soup)
           : Repair(soup).run();
}

} // namespace segment_mesh
