// SPDX-License-Identifier: LGPL-3.0-or-later

#include "soup/looks_like_machine_part.h"

#include "soup/vector_algebra.h"

#include <boost/unordered_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace segment_mesh {

namespace {

/// A plane with some faces of a mesh.
struct Plane
{
  std::size_t number_of_faces = 0;
  double area = 0;
};

/// The planes of the faces; those with nearly the same normal and distance are one.
std::vector<Plane> planes_of_faces(const Polygon_soup& soup, double area)
{
  constexpr double steps = 500;
  boost::unordered_map<std::array<long, 4>, Plane> planes;
  for (const Polygon_soup::Polygon& polygon : soup.polygons) {
    const Point vector = area_vector(soup.points, polygon), normal = unit_vector(vector);
    const double distance = inner_product(normal, minus(soup.points[polygon[0]], soup.points[0]));
    const std::array<long, 4> key = {std::lround(steps * normal[0]), std::lround(steps * normal[1]),
                                     std::lround(steps * normal[2]),
                                     std::lround(steps * distance / std::sqrt(area))};
    Plane& plane = planes[key];
    ++plane.number_of_faces;
    plane.area += length(vector) / 2;
  }
  std::vector<Plane> result;
  for (const auto& entry : planes)
    result.push_back(entry.second);
  return result;
}

} // namespace

bool looks_like_machine_part(const Polygon_soup& soup)
{
  double area = 0, area_of_large_planes = 0;
  for (const Polygon_soup::Polygon& polygon : soup.polygons)
    area += length(area_vector(soup.points, polygon)) / 2;
  std::size_t number_of_large_planes = 0;
  for (const Plane& plane : planes_of_faces(soup, area))
    if (plane.number_of_faces > 1 && plane.area >= 0.01 * area) {
      ++number_of_large_planes;
      area_of_large_planes += plane.area;
    }
  return number_of_large_planes > 1 && area_of_large_planes > 0.2 * area;
}

} // namespace segment_mesh
