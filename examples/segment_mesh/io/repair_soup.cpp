// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/repair_soup.h"

#include "io/split_pinched_polygons.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>

#include <algorithm>

namespace segment_mesh {

namespace PMP = CGAL::Polygon_mesh_processing;

namespace {

using Polygon = std::vector<std::size_t>;
using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

/// Orienting keeps the order of the faces and, where it turns none, of their corners.
std::size_t count_turned_faces(const std::vector<Point_3>& points,
                               const std::vector<Polygon>& before,
                               const std::vector<Polygon>& after)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const auto is_same_place = [&points](std::size_t a, std::size_t b) {
      return points[a] == points[b];
    };
    count += !std::equal(before[i].begin(), before[i].end(), after[i].begin(), is_same_place);
  }
  return count;
}

std::size_t count_used_points(std::size_t number_of_points,
                              const std::vector<Polygon>& polygons)
{
  std::vector<bool> is_used(number_of_points);
  for (const Polygon& polygon : polygons)
    for (const std::size_t i : polygon)
      is_used[i] = true;
  return std::size_t(std::count(is_used.begin(), is_used.end(), true));
}

} // namespace

Repair repair_soup(Polygon_soup& soup)
{
  std::vector<Point_3> points;
  for (const Point& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<Polygon> polygons;
  for (const Polygon_soup::Polygon& polygon : soup.polygons)
    polygons.emplace_back(polygon.begin(), polygon.end());
  const std::size_t number_of_used = count_used_points(points.size(), polygons);
  PMP::merge_duplicate_points_in_polygon_soup(points, polygons);
  const std::size_t merged_points = number_of_used - count_used_points(points.size(), polygons);
  split_pinched_polygons(points.size(), polygons);
  PMP::repair_polygon_soup(points, polygons);
  const std::size_t number_of_points = points.size();
  const std::vector<Polygon> before = polygons;
  PMP::orient_polygon_soup(points, polygons);

  const Repair repair = {count_turned_faces(points, before, polygons), merged_points, points.size() - number_of_points};
  soup.polygons = polygons;
  soup.points.clear();
  for (const Point_3& p : points)
    soup.points.push_back({p.x(), p.y(), p.z()});
  return repair;
}

} // namespace segment_mesh
