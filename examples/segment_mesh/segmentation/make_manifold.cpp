// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/Manifold.h"

#include "soup/is_oriented_manifold.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Region_segmentation/Surface/make_surface.h>

#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <vector>

namespace segment_mesh {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
namespace RS = CGAL::Region_segmentation;

using Point_3 = Manifold::Mesh::Point;

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

/// Polygons with points merged as the surface merges vertices, and points that they use. A polygon
/// that comes back to a point, as around a hole that a bridge joins to its boundary, gets a copy of
/// it.
class Repair
{
public:
  Repair(const Polygon_soup& soup, const RS::Surface& surface)
    : m_soup(soup)
    , m_surface(surface)
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
      m_result.point_of_mesh_point.push_back(m_point_at.at({p.x(), p.y(), p.z()}));
    }
    return std::move(m_result);
  }

private:
  /// The merged points at the corners; none if fewer than three are different.
  template <typename Polygon>
  std::vector<std::size_t> corners_of(const Polygon& polygon)
  {
    std::vector<std::size_t> ends; // of sides that are no points
    for (const std::size_t i : polygon)
      if (const std::size_t v = m_surface.merged_vertex(i); ends.empty() || ends.back() != v)
        ends.push_back(v);
    while (ends.size() > 1 && ends.front() == ends.back())
      ends.pop_back();
    const bool has_area = std::set<std::size_t>(ends.begin(), ends.end()).size() > 2;
    std::vector<std::size_t> corners;
    std::set<std::size_t> visited;
    for (std::size_t i = 0; i < ends.size() && has_area; ++i) {
      const std::size_t corner = index_of(ends[i]);
      const bool comes_back = !visited.insert(corner).second;
      corners.push_back(comes_back ? m_points.size() : corner);
      if (comes_back)
        m_points.push_back(m_points[corner]);
    }
    return corners;
  }

  std::size_t index_of(std::size_t vertex)
  {
    const auto [found, is_new] = m_index.emplace(vertex, m_points.size());
    if (is_new) {
      const Point& p = m_soup.points[vertex];
      m_points.emplace_back(p[0], p[1], p[2]);
      m_point_at.emplace(p, vertex);
    }
    return found->second;
  }

  const Polygon_soup& m_soup;
  const RS::Surface& m_surface;
  std::map<std::size_t, std::size_t> m_index; // in the points below, by vertex of the surface
  std::map<Point, std::size_t> m_point_at;    // the first point of the soup at a place
  std::vector<Point_3> m_points;
  std::vector<std::vector<std::size_t>> m_polygons;
  Manifold m_result;
};

} // namespace

Manifold make_manifold(const Polygon_soup& soup)
{
  const RS::Surface surface = RS::make_surface_of_polygon_soup(
    soup.points, soup.polygons, RS::parameters::component_links(false));
  bool has_merged_vertices = false;
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    has_merged_vertices |= surface.merged_vertex(v) != v;
  return !has_merged_vertices && is_oriented_manifold(soup) ? of_manifold(soup)
                                                            : Repair(soup, surface).run();
}

} // namespace segment_mesh
