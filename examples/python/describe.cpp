// SPDX-License-Identifier: GPL-3.0-or-later

#include "describe.h"

#include "segmentation/Manifold.h"
#include "soup/vector_algebra.h"

#include <CGAL/Region_segmentation/Segments/describe_segments.h>
#include <CGAL/Region_segmentation/Segments/no_segment.h>
#include <CGAL/Region_segmentation/exceptions.h>

#include <boost/property_map/property_map.hpp>

#include <iterator>
#include <map>
#include <utility>

namespace RS = CGAL::Region_segmentation;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Description = RS::Segment_description<std::int64_t, Kernel>;

/// With unused points that are not finite moved to the origin.
/// \throws Invalid_input if another one is not finite
Soup with_finite_points(Soup soup)
{
  for (const std::size_t i : soup.polygons.corners())
    if (!segment_mesh::is_finite(soup.points[i]))
      throw RS::Invalid_input("the point of vertex " + std::to_string(i) + " is not finite");
  for (segment_mesh::Point& p : soup.points)
    if (!segment_mesh::is_finite(p))
      p = {};
  return soup;
}

/// A description for each segment, in the order of their first faces, also of one whose faces all
/// have a point twice; the number of faces counts these.
std::vector<Description> with_all_faces(std::vector<Description> descriptions,
                                        const std::vector<std::int64_t>& labels)
{
  std::map<std::int64_t, std::size_t> position; // by label
  std::vector<Description> result;
  for (const std::int64_t label : labels) {
    if (label == RS::no_segment)
      continue;
    const auto [place, is_new] = position.emplace(label, result.size());
    if (is_new) {
      result.emplace_back().segment = label;
      result.back().surface.kind = RS::Surface_kind::PLANE;
    }
    ++result[place->second].number_of_faces;
  }
  for (Description& d : descriptions) {
    Description& place = result[position.at(d.segment)];
    d.number_of_faces = place.number_of_faces;
    place = std::move(d);
  }
  return result;
}

template <typename Triple>
py::tuple to_tuple(const Triple& t)
{
  return py::make_tuple(t.x(), t.y(), t.z());
}

py::dict to_dictionary(const Description& d)
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
  std::vector<Description> descriptions;
  {
    const py::gil_scoped_release release;
    const segment_mesh::Manifold manifold = make_manifold(with_finite_points(soup));
    const std::vector<std::int64_t> labels_of_mesh = manifold.values_of_mesh_faces(labels);
    RS::describe_segments(manifold.mesh,
                          boost::make_iterator_property_map(labels_of_mesh.begin(),
                                                            get(boost::face_index, manifold.mesh)),
                          std::back_inserter(descriptions));
    descriptions = with_all_faces(std::move(descriptions), labels);
  }
  py::list result;
  for (const auto& d : descriptions)
    result.append(to_dictionary(d));
  return result;
}
