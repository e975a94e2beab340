// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_MEASURES_SURFACE_GEOMETRY_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_MEASURES_SURFACE_GEOMETRY_H

#include <CGAL/Region_segmentation/exceptions.h>
#include <CGAL/Region_segmentation/internal/reading/Area_vector_sum.h>
#include <CGAL/Region_segmentation/internal/measures/Contingency_table.h>
#include <CGAL/Region_segmentation/internal/reading/Mesh_traversal.h>
#include <CGAL/Region_segmentation/internal/support/unit_of_coordinates.h>
#include <CGAL/Region_segmentation/Double_3.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Multiplies all coordinates by the power of two that brings the largest one of a vertex with faces into [1, 2). Exact,
/// so that measures that do not depend on scale are bitwise the same, and areas stay in the range of
/// double.
inline void normalize_scale(std::vector<Double_3>& points, double largest_coordinate)
{
  const double scale = 1 / power_of_two_below(largest_coordinate);
  for (Double_3& p : points)
    p = scale * p;
}

/// The points of a mesh by iteration order, in a scale of their own.
/// \throws Invalid_input if a point is not finite
template <typename FaceGraph, typename Pack>
std::vector<Double_3> read_normalized_points(const Mesh_traversal<FaceGraph, Pack>& traversal, const Pack& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                          get_const_property_map(vertex_point, traversal.mesh()));
  std::vector<Double_3> points;
  points.reserve(traversal.number_of_vertices());
  double largest = 0;
  for (auto v : vertices(traversal.mesh())) {
    const auto& p = get(point_map, v);
    points.push_back({CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])});
    if (!is_finite(points.back()))
      throw Invalid_input("the point of vertex " + std::to_string(points.size() - 1) +
                          " is not finite");
    const Double_3& q = points.back();
    if (halfedge(v, traversal.mesh()) != boost::graph_traits<FaceGraph>::null_halfedge())
      largest = (std::max)({largest, std::abs(q.x), std::abs(q.y), std::abs(q.z)});
  }
  normalize_scale(points, largest);
  return points;
}

/// Calls `f(polygon)` for each face in order, with its points from the vertex of lowest number on,
/// so that sums do not depend on the halfedge where a mesh type starts.
template <typename FaceGraph, typename Pack, typename F>
void for_each_polygon(const Mesh_traversal<FaceGraph, Pack>& traversal, const std::vector<Double_3>& points,
                      F f)
{
  const FaceGraph& mesh = traversal.mesh();
  std::vector<std::size_t> corners;
  std::vector<Double_3> polygon;
  for (auto fd : faces(mesh)) {
    corners.clear();
    polygon.clear();
    for (auto h : CGAL::halfedges_around_face(halfedge(fd, mesh), mesh))
      corners.push_back(traversal.source_rank(h));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    for (std::size_t v : corners)
      polygon.push_back(points[v]);
    f(polygon);
  }
}

inline Double_3 area_vector(const std::vector<Double_3>& polygon)
{
  Area_vector_sum sum(polygon[0], polygon[1]);
  for (std::size_t i = 2; i < polygon.size(); ++i)
    sum.add(polygon[i]);
  return sum.area_vector();
}

/// The centroid of a polygon whose area vector is not zero: that of the triangles of its fan, each
/// with its area as seen along the area vector, so that it may be concave.
inline Double_3 centroid(const std::vector<Double_3>& polygon, const Double_3& area_vector)
{
  const double area = norm(area_vector);
  const Double_3 normal = (1 / area) * area_vector;
  Double_3 sum{}; // relative to the first vertex
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Double_3 u = polygon[i - 1] - polygon[0], v = polygon[i] - polygon[0];
    sum = sum + dot(cross(u, v), normal) / area * (u + v); // the square of the area may underflow
  }
  return polygon[0] + 1. / 6 * sum;
}

/// The area of every face, in a scale of the mesh's own.
template <typename FaceGraph, typename Pack>
Face_areas face_areas(const Mesh_traversal<FaceGraph, Pack>& traversal, const Pack& np)
{
  Face_areas areas;
  areas.of_face.reserve(traversal.number_of_faces());
  for_each_polygon(traversal, read_normalized_points(traversal, np), [&](const auto& polygon) {
    areas.of_face.push_back(norm(area_vector(polygon)));
  });
  return areas;
}

/// The mean distance of the surface to its centroid: the centroids c_f of the faces stand for them,
/// weighted by area. 0 where the surface has no area.
template <typename FaceGraph, typename Pack>
double mean_distance_to_centroid(const Mesh_traversal<FaceGraph, Pack>& traversal,
                                 const std::vector<Double_3>& points)
{
  struct Weighted_point
  {
    double weight;
    Double_3 point;
  };
  std::vector<Weighted_point> centers;
  centers.reserve(traversal.number_of_faces());
  double total = 0;
  Double_3 sum{};
  for_each_polygon(traversal, points, [&](const std::vector<Double_3>& polygon) {
    const Double_3 area = area_vector(polygon);
    if (!(dot(area, area) > 0))
      return;
    centers.push_back({norm(area), centroid(polygon, area)});
    total += centers.back().weight;
    sum = sum + centers.back().weight * centers.back().point;
  });
  if (total == 0)
    return 0;
  const Double_3 center = (1 / total) * sum;
  double sum_of_distances = 0;
  for (const Weighted_point& c : centers)
    sum_of_distances += c.weight * norm(c.point - center);
  return sum_of_distances / total;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_MEASURES_SURFACE_GEOMETRY_H
