// SPDX-License-Identifier: LGPL-3.0-or-later

#include "core.h"

#include "segmentation/find_part_faces.h"
#include "segmentation/make_manifold.h"
#include "segmentation/segment_attributes.h"

#include <CGAL/HalfedgeDS_default.h>
#include <CGAL/HalfedgeDS_items_2.h>
#include <CGAL/Region_segmentation/Segments/close_segments.h>
#include <CGAL/Region_segmentation/Segments/describe_segments.h>
#include <CGAL/Region_segmentation/Segments/no_segment.h>
#include <CGAL/Region_segmentation/Segments/transfer_labels.h>
#include <CGAL/Region_segmentation/Superfacets/smooth_borders.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/graph_traits_HalfedgeDS_default.h>

#include <pybind11/stl.h>

#include <array>
#include <deque>
#include <functional>
#include <iterator>
#include <utility>

using Kernel = CGAL::Simple_cartesian<double>;

struct Items : CGAL::HalfedgeDS_items_2
{
  template <typename Refs, typename Traits>
  struct Vertex_wrapper
  {
    using Vertex = CGAL::HalfedgeDS_vertex_base<Refs, CGAL::Tag_true, typename Traits::Point_3>;
  };
};

/// A face graph of CGAL that is not subject to the GPL. (As a class of its own it has dynamic
/// properties.)
using Halfedges = CGAL::HalfedgeDS_default<Kernel, Items>;
struct Mesh : Halfedges
{};

namespace boost {
template <>
struct graph_traits<Mesh> : graph_traits<Halfedges>
{};
template <>
struct property_map<Mesh, CGAL::vertex_point_t> : property_map<Halfedges, CGAL::vertex_point_t>
{};
} // namespace boost
template <>
struct CGAL::graph_has_property<Mesh, CGAL::vertex_point_t> : CGAL::Tag_true
{};

namespace RS = CGAL::Region_segmentation;
using namespace pybind11::literals;

namespace {

template <typename Value>
py::object to_object(const Value& value)
{
  return py::cast(value);
}

template <typename Value, std::size_t n>
py::object to_object(const std::array<Value, n>& values)
{
  py::tuple result(n);
  for (std::size_t i = 0; i < n; ++i)
    result[i] = to_object(values[i]);
  return std::move(result);
}

/// Adds attributes to a dictionary.
auto adder(py::dict& dictionary)
{
  return
    [&dictionary](const char* name, const auto& value) { dictionary[name] = to_object(value); };
}

/// The faces of a manifold have labels, and numbers in its soup.
struct Labelled_manifold : segment_mesh::Manifold_of<Mesh>
{
  explicit Labelled_manifold(const Soup& soup)
    : Labelled_manifold(soup, Labels(soup.polygons.size(), RS::no_segment))
  {}
  Labelled_manifold(const Soup& soup, const Labels& labels_of_soup)
    : Manifold_of<Mesh>(segment_mesh::make_manifold_of<Mesh>(soup))
    , map(get(CGAL::dynamic_face_property_t<std::int32_t>(), mesh))
    , number(get(CGAL::dynamic_face_property_t<std::int32_t>(), mesh))
    , labels(labels_of_soup)
  {
    auto f = face_of_mesh_face.begin();
    for (const auto face : faces(mesh)) {
      put(number, face, std::int32_t(*f));
      put(map, face, labels[*f++]);
    }
  }

  /// By face of the soup; those of faces that are not in the mesh are as before, or `no_segment`.
  const Labels& labels_of_soup()
  {
    for (const auto face : faces(mesh))
      labels[get(number, face)] = get(map, face);
    return labels;
  }

  boost::property_map<Mesh, CGAL::dynamic_face_property_t<std::int32_t>>::type map, number;
  Labels labels;
};

py::dict to_dictionary(const RS::Fitted_surface<Kernel>& surface)
{
  py::dict result;
  segment_mesh::visit_attributes_of_surface(surface, adder(result));
  return result;
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
  result["surface"] = to_dictionary(d.surface);
  result["surface_error"] = d.surface_error();
  return result;
}

py::list describe_segments(const Soup& soup, const Array<std::int32_t>& labels)
{
  std::vector<RS::Segment_description<std::int32_t, Kernel>> descriptions;
  const Labels labels_of_soup = to_vector(labels);
  run(1, py::none(), [&](Visitor&) {
    Labelled_manifold manifold(soup, labels_of_soup);
    RS::describe_segments(manifold.mesh, manifold.map, std::back_inserter(descriptions));
  });
  py::list result;
  for (const auto& d : descriptions)
    result.append(to_dictionary(d));
  return result;
}

py::dict to_dictionary(const RS::Part_face<Kernel>& face)
{
  py::list neighbors;
  for (const RS::Part_face_neighbor& n : face.neighbors)
    neighbors.append(
      py::dict("face"_a = n.face, "length"_a = n.length, "is_smooth"_a = n.is_smooth));
  py::dict result("surface"_a = to_dictionary(face.surface), "neighbors"_a = neighbors);
  segment_mesh::visit_attributes_of_face(face, adder(result));
  return result;
}

py::tuple find_part_faces(const Soup& soup, double tolerance, const py::object& progress)
{
  const auto found = run(1, progress, [&](Visitor& visitor) {
    return segment_mesh::find_part_faces(soup, tolerance,
                                         RS::parameters::visitor(std::ref(visitor)));
  });
  py::list faces;
  for (const auto& face : found.faces)
    faces.append(to_dictionary(face));
  return py::make_tuple(to_array(found.labels), faces);
}

/// Of each solid its segment, coordinates, corners of all faces, their sizes, and faces of the
/// soup.
py::list close_segments(const Soup& soup, const Array<std::int32_t>& labels, double clearance)
{
  Labelled_manifold manifold(soup, to_vector(labels));
  std::deque<RS::Segment_piece<Mesh, Mesh, std::int32_t>> solids;
  run(1, py::none(), [&](Visitor&) {
    RS::close_segments(manifold.mesh, manifold.map, std::back_inserter(solids),
                       RS::parameters::clearance(clearance));
  });
  py::list result;
  for (const auto& solid : solids) {
    std::vector<double> coordinates;
    const auto index = get(CGAL::dynamic_vertex_property_t<std::int32_t>(), solid.mesh);
    for (const auto v : vertices(solid.mesh)) {
      put(index, v, std::int32_t(coordinates.size() / 3));
      const Kernel::Point_3& p = get(get(CGAL::vertex_point, solid.mesh), v);
      coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
    }
    Labels corners, sizes, faces_of_soup;
    for (const auto f : faces(solid.mesh)) {
      const std::size_t before = corners.size();
      for (const auto v : CGAL::vertices_around_face(halfedge(f, solid.mesh), solid.mesh))
        corners.push_back(get(index, v));
      sizes.push_back(std::int32_t(corners.size() - before));
      const auto original = solid.faces[sizes.size() - 1];
      faces_of_soup.push_back(
        original == boost::graph_traits<Mesh>::null_face() ? -1 : get(manifold.number, original));
    }
    result.append(py::make_tuple(solid.segment, to_array(coordinates), to_array(corners),
                                 to_array(sizes), to_array(faces_of_soup)));
  }
  return result;
}

Array<std::int32_t> transfer_labels(const Soup& from, const Array<std::int32_t>& labels,
                                    const Soup& to)
{
  const Labels labels_of_from = to_vector(labels);
  return to_array(run(1, py::none(), [&](Visitor&) {
    Labelled_manifold source(from, labels_of_from), target(to);
    RS::transfer_labels(source.mesh, source.map, target.mesh, target.map);
    return target.labels_of_soup();
  }));
}

Array<std::int32_t> smooth_borders(const Soup& soup, const Array<std::int32_t>& labels,
                                   const py::object& progress)
{
  const Labels before = to_vector(labels);
  return to_array(run(1, progress, [&](Visitor& visitor) {
    Labelled_manifold manifold(soup, before);
    RS::smooth_borders(manifold.mesh, manifold.map, {}, RS::parameters::visitor(std::ref(visitor)));
    return manifold.labels_of_soup();
  }));
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
