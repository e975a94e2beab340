// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/looks_like_machine_part.h"

#include "soup/vector_algebra.h"

#include <CGAL/Region_segmentation/grow_regions.h>
#include <CGAL/Region_segmentation/make_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace segment_mesh {

namespace RS = CGAL::Region_segmentation;

namespace {

double area_of(const Polygon_soup& soup, const Polygon_soup::Polygon& polygon)
{
  Point normal = {0, 0, 0};
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Point& start = soup.points[polygon[0]];
    normal = plus(normal, cross_product(minus(soup.points[polygon[i - 1]], start),
                                        minus(soup.points[polygon[i]], start)));
  }
  return std::sqrt(inner_product(normal, normal)) / 2;
}

} // namespace

bool looks_like_machine_part(const Polygon_soup& soup, const Segmentation& learned)
{
  constexpr double largest_share = 0.85, least_share = 0.001;
  constexpr std::ptrdiff_t fewest_regions = 5;
  std::vector<double> areas(learned.number_of_segments, 0);
  for (std::size_t f = 0; f < soup.polygons.size(); ++f)
    areas[learned.segment_of_face[f]] += area_of(soup, soup.polygons[f]);
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
  if (areas.empty() || !(*std::max_element(areas.begin(), areas.end()) > largest_share * area))
    return false;

  const RS::Surface surface = RS::make_surface_of_polygon_soup(soup.points, soup.polygons);
  const RS::Partition regions = RS::grow_regions(
    surface, RS::mark_feature_edges(surface, 20, RS::Feature_convexity::ALL));
  std::vector<double> region_areas(regions.number_of_parts(), 0);
  for (std::size_t f = 0; f < regions.size(); ++f)
    region_areas[regions[f]] += surface.area(f);
  return std::count_if(region_areas.begin(), region_areas.end(), [&](double a) {
           return a > least_share * surface.area();
         }) >= fewest_regions;
}

} // namespace segment_mesh
