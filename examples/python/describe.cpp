// SPDX-License-Identifier: GPL-3.0-or-later

#include "describe.h"

#include <CGAL/Region_segmentation/Segments/describe_segments.h>
#include <CGAL/Region_segmentation/exceptions.h>

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <iterator>

namespace PMP = CGAL::Polygon_mesh_processing;
namespace RS = CGAL::Region_segmentation;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// \throws Invalid_input that names the first polygon with a point twice
void refuse_repeated_points(const std::vector<std::vector<std::size_t>>& polygons)
{
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    std::vector<std::size_t> corners = polygons[f];
    std::sort(corners.begin(), corners.end());
    if (std::adjacent_find(corners.begin(), corners.end()) != corners.end())
      throw RS::Invalid_input("face " + std::to_string(f) + ", from 0: has a point twice");
  }
}

/// A half-edge mesh of the polygons, in their order: equal points are merged, polygons oriented,
/// and what is not manifold is torn apart.
Mesh make_mesh(const Soup& soup)
{
  std::vector<Kernel::Point_3> points;
  for (const auto& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::vector<std::size_t>> polygons;
  for (const segment_mesh::Polygons::Polygon polygon : soup.polygons)
    polygons.emplace_back(polygon.begin(), polygon.end());
  PMP::merge_duplicate_points_in_polygon_soup(points, polygons);
  refuse_repeated_points(polygons);
  PMP::orient_polygon_soup(points, polygons);
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  return mesh;
}

template <typename Triple>
py::tuple to_tuple(const Triple& t)
{
  return py::make_tuple(t.x(), t.y(), t.z());
}

py::dict to_dictionary(const RS::Segment_description<std::int64_t, Kernel>& d)
{
  using namespace pybind11::literals;
  py::list axes, neighbors;
  for (const auto& axis : d.axes)
    axes.append(to_tuple(axis));
  for (const auto& n : d.neighbors)
    neighbors.append(py::dict("segment"_a = n.segment, "border_length"_a = n.border_length,
                              "mean_signed_deviation"_a = n.mean_signed_deviation));
  const char* const types[] = {"plane", "cylinder", "cone", "sphere"};
  const auto& s = d.surface;
  const bool is_cone = s.kind == RS::Surface_kind::CONE;
  const py::dict primitive(
    "type"_a = types[int(s.kind)], "point"_a = to_tuple(is_cone ? s.apex() : s.point),
    "direction"_a = to_tuple(s.kind == RS::Surface_kind::SPHERE ? Kernel::Vector_3(0, 0, 0)
                                                                : s.direction),
    "radius"_a = is_cone ? 0 : s.radius, "half_angle"_a = s.angle, "error"_a = d.surface_error());
  return py::dict("segment"_a = d.segment, "number_of_faces"_a = d.number_of_faces,
                  "area"_a = d.area, "volume"_a = d.volume, "centroid"_a = to_tuple(d.centroid),
                  "axes"_a = axes,
                  "extents"_a = py::make_tuple(d.extents[0], d.extents[1], d.extents[2]),
                  "border_length"_a = d.border_length, "boundary_length"_a = d.boundary_length,
                  "neighbors"_a = neighbors, "primitive"_a = primitive);
}

} // namespace

py::list describe(const Soup& soup, const std::vector<std::int64_t>& labels)
{
  std::vector<RS::Segment_description<std::int64_t, Kernel>> descriptions;
  {
    const py::gil_scoped_release release;
    Mesh mesh = make_mesh(soup);
    auto segment = mesh.add_property_map<Mesh::Face_index, std::int64_t>("f:segment").first;
    for (auto f : faces(mesh))
      segment[f] = labels[std::size_t(f)];
    RS::describe_segments(mesh, segment, std::back_inserter(descriptions));
  }
  py::list result;
  for (const auto& d : descriptions)
    result.append(to_dictionary(d));
  return result;
}
