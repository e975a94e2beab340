// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/Manifold.h"

#include "segmentation/make_surface_mesh.h"
#include "soup/link_corners.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>

#include <algorithm>
#include <map>
#include <numeric>

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
Manifold of_manifold(const Polygon_soup& soup, const Corner_links& links)
{
  Manifold result;
  result.mesh = make_surface_mesh<Manifold::Mesh>(soup, links);
  result.face_of_mesh_face.resize(soup.polygons.size());
  std::iota(result.face_of_mesh_face.begin(), result.face_of_mesh_face.end(), std::size_t(0));
  result.point_of_mesh_point.resize(soup.points.size());
  std::iota(result.point_of_mesh_point.begin(), result.point_of_mesh_point.end(), std::size_t(0));
  return result;
}

/// Polygons with equal points merged, and points that they use.
class Repair
{
public:
  explicit Repair(const Polygon_soup& soup)
    : m_soup(soup)
  {}

  Manifold run()
  {
    for (std::size_t f = 0; f < m_soup.polygons.size(); ++f) {
      const auto& polygon = m_soup.polygons[f];
      if (polygon.size() < 3 || !has_different_points(polygon))
        continue;
      m_polygons.emplace_back();
      for (std::size_t i : polygon)
        m_polygons.back().push_back(index_of(i));
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
  template <typename Polygon>
  bool has_different_points(const Polygon& polygon) const
  {
    std::vector<Point> points;
    for (std::size_t i : polygon)
      points.push_back(m_soup.points[i]);
    return are_different(std::move(points));
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
  const std::optional<Corner_links> links = link_corners(soup);
  return links && are_different({soup.points.begin(), soup.points.end()})
           ? of_manifold(soup, *links)
           : Repair(soup).run();
}

} // namespace segment_mesh
