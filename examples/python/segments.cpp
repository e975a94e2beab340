// SPDX-License-Identifier: GPL-3.0-or-later

#include "core.h"

#include "segmentation/Manifold.h"
#include "segmentation/segment_attributes.h"

// Of the program, compiled here since setuptools writes objects beside sources.
#include "segmentation/make_manifold.cpp"

#include <CGAL/Region_segmentation/Part_faces/find_part_faces.h>
#include <CGAL/Region_segmentation/Segments/close_segments.h>
#include <CGAL/Region_segmentation/Segments/describe_segments.h>
#include <CGAL/Region_segmentation/Segments/no_segment.h>
#include <CGAL/Region_segmentation/Segments/transfer_labels.h>
#include <CGAL/Region_segmentation/Superfacets/smooth_borders.h>

#include <array>
#include <functional>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>

namespace RS = CGAL::Region_segmentation;
using namespace pybind11::literals;

namespace {

using segment_mesh::Manifold;
using Mesh = Manifold::Mesh;
using Kernel = CGAL::Simple_cartesian<double>;

template <typename Number, typename = std::enable_if_t<std::is_arithmetic<Number>::value>>
py::object to_object(Number value)
{
  return py::cast(value);
}

py::object to_object(const std::array<double, 3>& values)
{
  return py::make_tuple(values[0], values[1], values[2]);
}

/// Of a point or a vector.
template <typename Triple, typename = decltype(std::declval<Triple>().x())>
py::object to_object(const Triple& t)
{
  return py::make_tuple(t.x(), t.y(), t.z());
}

py::object to_object(const std::array<Kernel::Vector_3, 3>& vectors)
{
  py::list list;
  for (const Kernel::Vector_3& vector : vectors)
    list.append(to_object(vector));
  return std::move(list);
}

/// Adds attributes to a dictionary.
auto adder(py::dict& dictionary)
{
  return
    [&dictionary](const char* name, const auto& value) { dictionary[name] = to_object(value); };
}

/// Labels of the faces of a manifold; of the others of its soup `no_segment`.
struct Labelled_manifold : Manifold
{
  explicit Labelled_manifold(const Soup& soup)
    : Manifold(make_manifold(soup))
    , labels(mesh.number_of_faces())
    , size(soup.polygons.size())
  {}
  Labelled_manifold(const Soup& soup, const Labels& labels_of_soup)
    : Labelled_manifold(soup)
  {
    labels = values_of_mesh_faces(labels_of_soup);
  }

  auto map() { return segment_mesh::face_map(mesh, labels); }

  Labels labels_of_soup() const
  {
    Labels result(size, RS::no_segment);
    for (std::size_t f = 0; f < labels.size(); ++f)
      result[face_of_mesh_face[f]] = labels[f];
    return result;
  }

  Labels labels;
  std::size_t size;
};

/// The surface that fits a segment or is that of a part face, see `from_apex()`.
py::dict to_dictionary(const RS::Fitted_surface<Kernel>& s)
{
  return py::dict("type"_a = segment_mesh::name_of(s.kind), "point"_a = to_object(s.point),
                  "direction"_a = to_object(
                    s.kind == RS::Surface_kind::SPHERE ? Kernel::Vector_3(0, 0, 0) : s.direction),
                  "radius"_a = s.radius, "minor_radius"_a = s.minor_radius,
                  "half_angle"_a = s.angle * 180 / CGAL_PI);
}

py::dict to_dictionary(const RS::Segment_description<std::int32_t, Kernel>& d)
{
  py::dict result("segment"_a = d.segment, "number_of_faces"_a = d.number_of_faces);
  segment_mesh::visit_attributes(d, adder(result));
  py::list neighbors;
  for (const auto& n : d.neighbors) {
    py::dict neighbor;
    segment_mesh::visit_attributes_of_neighbor(n, adder(neighbor));
    neighbors.append(neighbor);
  }
  result["neighbors"] = neighbors;
  result["primitive"] = to_dictionary(segment_mesh::from_apex(d.surface));
  result["primitive"]["error"] = d.surface_error();
  return result;
}

py::list describe_segments(const Soup& soup, const Array<std::int32_t>& labels)
{
  std::vector<RS::Segment_description<std::int32_t, Kernel>> descriptions;
  const Labels labels_of_soup = to_vector(labels);
  run(1, py::none(), [&](Visitor&) {
    Labelled_manifold manifold(soup, labels_of_soup);
    RS::describe_segments(manifold.mesh, manifold.map(), std::back_inserter(descriptions));
  });
  py::list result;
  for (const auto& d : descriptions)
    result.append(to_dictionary(d));
  return result;
}

py::dict to_dictionary(const RS::Part_face<Kernel>& face)
{
  const RS::Fitted_surface<Kernel> s = segment_mesh::from_apex(face.surface);
  py::list neighbors;
  for (const RS::Part_face_neighbor& n : face.neighbors)
    neighbors.append(
      py::dict("face"_a = n.face, "length"_a = n.length, "is_smooth"_a = n.is_smooth));
  py::dict result = to_dictionary(s);
  result["is_concave"] = s.side < 0;
  result["extent"] = py::make_tuple(s.lowest, s.highest);
  result["deviation"] = s.deviation;
  result["role"] = segment_mesh::name_of(face.role);
  result["area"] = face.area;
  result["first_on_surface"] = face.first_on_surface;
  result["first_on_axis"] = face.first_on_axis;
  result["neighbors"] = neighbors;
  return result;
}

py::tuple find_part_faces(const Soup& soup, const py::object& progress)
{
  std::vector<RS::Part_face<Kernel>> faces;
  const Labels labels = run(1, progress, [&](Visitor& visitor) {
    Labelled_manifold manifold(soup);
    RS::find_part_faces(manifold.mesh, manifold.map(), std::back_inserter(faces),
                        RS::parameters::visitor(std::ref(visitor)));
    return manifold.labels_of_soup();
  });
  py::list result;
  for (const auto& face : faces)
    result.append(to_dictionary(face));
  return py::make_tuple(to_array(labels), result);
}

/// Of each solid its segment, coordinates, corners of all faces, their sizes, and faces of the
/// soup.
py::list close_segments(const Soup& soup, const Array<std::int32_t>& labels, double clearance)
{
  Labelled_manifold manifold(soup, to_vector(labels));
  std::vector<RS::Segment_piece<Mesh, Mesh, std::int32_t>> solids;
  run(1, py::none(), [&](Visitor&) {
    RS::close_segments(manifold.mesh, manifold.map(), std::back_inserter(solids),
                       RS::parameters::clearance(clearance));
  });
  py::list result;
  for (const auto& solid : solids) {
    std::vector<double> coordinates;
    for (const auto v : solid.mesh.vertices())
      for (const double x :
           {solid.mesh.point(v).x(), solid.mesh.point(v).y(), solid.mesh.point(v).z()})
        coordinates.push_back(x);
    Labels corners, sizes, faces;
    for (const auto f : solid.mesh.faces()) {
      const std::size_t before = corners.size();
      for (const auto v : vertices_around_face(solid.mesh.halfedge(f), solid.mesh))
        corners.push_back(std::int32_t(v));
      sizes.push_back(std::int32_t(corners.size() - before));
      const auto original = solid.faces[f];
      faces.push_back(
        original == Mesh::null_face() ? -1 : std::int32_t(manifold.face_of_mesh_face[original]));
    }
    result.append(py::make_tuple(solid.segment, to_array(coordinates), to_array(corners),
                                 to_array(sizes), to_array(faces)));
  }
  return result;
}

Array<std::int32_t> transfer_labels(const Soup& from, const Array<std::int32_t>& labels,
                                    const Soup& to)
{
  const Labels labels_of_from = to_vector(labels);
  return to_array(run(1, py::none(), [&](Visitor&) {
    Labelled_manifold source(from, labels_of_from), target(to);
    RS::transfer_labels(source.mesh, source.map(), target.mesh, target.map());
    return target.labels_of_soup();
  }));
}

Array<std::int32_t> smooth_borders(const Soup& soup, const Array<std::int32_t>& labels,
                                   const py::object& progress)
{
  Labels result = to_vector(labels);
  run(1, progress, [&](Visitor& visitor) {
    Labelled_manifold manifold(soup, result);
    RS::smooth_borders(manifold.mesh, manifold.map(), {},
                       RS::parameters::visitor(std::ref(visitor)));
    for (std::size_t f = 0; f < manifold.labels.size(); ++f)
      result[manifold.face_of_mesh_face[f]] = manifold.labels[f];
  });
  return to_array(result);
}

} // namespace

void define_functions_of_segments(py::module_& module)
{
  module.def("describe_segments", &describe_segments);
  module.def("find_part_faces", &find_part_faces);
  module.def("close_segments", &close_segments);
  module.def("transfer_labels", &transfer_labels);
  module.def("smooth_borders", &smooth_borders);
}
