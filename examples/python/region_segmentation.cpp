// SPDX-License-Identifier: GPL-3.0-or-later
//
// A Python module: points and faces as arrays in, labels out.

#include "Soup.h"
#include "describe.h"

#include <CGAL/Region_segmentation/Methods/Learned_merging.h>
#include <CGAL/Region_segmentation/Methods/Two_step.h>
#include <CGAL/Region_segmentation/Methods/Visibility_merging.h>
#include <CGAL/Region_segmentation/Part_faces/Smooth_faces.h>
#include <CGAL/Region_segmentation/Segmenter.h>
#include <CGAL/Region_segmentation/version.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace RS = CGAL::Region_segmentation;

namespace {

using Labels = py::array_t<std::size_t>;
using Seeds = std::vector<std::int64_t>;

/// \throws pybind11::type_error or std::invalid_argument unless it is None or an integer from 1 on
std::optional<std::size_t> to_number_of_segments(const py::object& number)
{
  const auto expected = [&] {
    return "number_of_segments: not None or an integer of at least 1, but " +
           std::string(py::repr(number));
  };
  if (number.is_none())
    return std::nullopt;
  const bool is_bool = py::isinstance<py::bool_>(number) ||
                       py::isinstance(number, py::module_::import("numpy").attr("bool_"));
  if (is_bool || PyIndex_Check(number.ptr()) == 0)
    throw py::type_error(expected());
  const py::ssize_t value = PyNumber_AsSsize_t(number.ptr(), nullptr); // the nearest that there is
  if (value == -1 && PyErr_Occurred() != nullptr)
    throw py::error_already_set();
  if (value < 1)
    throw std::invalid_argument(expected());
  return std::size_t(value);
}

/// A soup prepared by one of the methods.
class Prepared
{
public:
  virtual ~Prepared() = default;
  /// Without a number the method chooses one. Returns the number of segments.
  virtual std::size_t segment(std::optional<std::size_t> number_of_segments,
                              std::vector<std::size_t>& labels) const = 0;
  virtual void add_constraints(const Edges& edges) = 0;
  virtual void set_seeds(const Seeds& seeds) = 0;
  virtual const RS::Partition& regions() const = 0;
  virtual const RS::Merge_tree& merge_tree() const = 0;
};

template <typename Method>
class Prepared_by : public Prepared
{
  using Segmenter = RS::Polygon_soup_segmenter<Method>;

  [[noreturn]] static void refuse(const char* what)
  {
    throw std::invalid_argument(std::string("method two-step ") + what);
  }

public:
  Prepared_by(const Soup& soup, bool component_links)
    : m_segmenter(soup.points, soup.polygons,
                  RS::parameters::method(Method()).component_links(component_links))
  {}

  std::size_t segment(std::optional<std::size_t> number_of_segments,
                      std::vector<std::size_t>& labels) const override
  {
    if (number_of_segments)
      return m_segmenter.segment(labels, *number_of_segments);
    if constexpr (Segmenter::needs_number)
      refuse("needs number_of_segments");
    else
      return m_segmenter.segment(labels);
  }
  void add_constraints(const Edges& edges) override { m_segmenter.add_constraints(edges); }
  void set_seeds(const Seeds& seeds) override { m_segmenter.set_seeds(seeds); }
  const RS::Partition& regions() const override
  {
    if constexpr (Segmenter::needs_number)
      refuse("has no regions for all numbers");
    else
      return m_segmenter.regions();
  }
  const RS::Merge_tree& merge_tree() const override
  {
    if constexpr (Segmenter::needs_number)
      refuse("has no tree for all numbers");
    else
      return m_segmenter.merge_tree();
  }

private:
  Segmenter m_segmenter;
};

std::unique_ptr<Prepared> prepare(const std::string& method, const Soup& soup, bool component_links)
{
  if (method == "learned")
    return std::make_unique<Prepared_by<RS::Learned_merging>>(soup, component_links);
  if (method == "visibility")
    return std::make_unique<Prepared_by<RS::Visibility_merging>>(soup, component_links);
  if (method == "two-step")
    return std::make_unique<Prepared_by<RS::Two_step>>(soup, component_links);
  if (method == "smooth-faces")
    return std::make_unique<Prepared_by<RS::Smooth_faces>>(soup, component_links);
  throw std::invalid_argument("method: not learned, visibility, two-step or smooth-faces");
}

/// The class of the module.
class Segmenter
{
public:
  Segmenter(const py::object& points, const py::object& faces, const std::string& method,
            const py::object& constrained_edges, const py::object& seeds, bool component_links,
            const py::object& face_sizes)
    : m_soup(make_soup(points, faces, face_sizes))
  {
    {
      const py::gil_scoped_release release;
      m_prepared = prepare(method, m_soup, component_links);
    }
    if (!constrained_edges.is_none())
      add_constraints(constrained_edges);
    if (!seeds.is_none())
      set_seeds(seeds);
  }

  Labels segment(std::optional<std::size_t> number_of_segments) const
  {
    std::vector<std::size_t> labels(m_soup.polygons.size());
    std::size_t n = 0;
    {
      const py::gil_scoped_release release;
      n = m_prepared->segment(number_of_segments, labels);
    }
    if (number_of_segments && n != *number_of_segments) {
      const std::string text = std::to_string(n) +
                               " segments: " + std::to_string(*number_of_segments) +
                               " are not possible";
      if (PyErr_WarnEx(PyExc_UserWarning, text.c_str(), 1) != 0)
        throw py::error_already_set();
    }
    return Labels(py::ssize_t(labels.size()), labels.data());
  }

  void add_constraints(const py::object& constrained_edges)
  {
    const Edges edges = make_edges(m_soup, constrained_edges);
    const py::gil_scoped_release release;
    m_prepared->add_constraints(edges);
  }

  void set_seeds(const py::object& object)
  {
    const Seeds seeds = make_labels(m_soup, object, "seeds");
    const py::gil_scoped_release release;
    m_prepared->set_seeds(seeds);
  }

  Labels regions() const
  {
    const RS::Partition& regions = m_prepared->regions();
    const std::vector<std::size_t> labels(regions.begin(), regions.end());
    return Labels(py::ssize_t(labels.size()), labels.data());
  }

  py::list merges() const
  {
    py::list result;
    for (const RS::Merge_tree::Merge& merge : m_prepared->merge_tree().merges())
      result.append(
        py::make_tuple(std::size_t(merge.kept), std::size_t(merge.removed), merge.cost));
    return result;
  }

private:
  const Soup m_soup;
  std::unique_ptr<Prepared> m_prepared;
};

Labels segment(const py::object& points, const py::object& faces,
               const py::object& number_of_segments, const std::string& method,
               const py::object& constrained_edges, const py::object& seeds, bool component_links,
               const py::object& face_sizes)
{
  const std::optional<std::size_t> number = to_number_of_segments(number_of_segments);
  return Segmenter(points, faces, method, constrained_edges, seeds, component_links, face_sizes)
    .segment(number);
}

py::array_t<std::size_t> segment_borders(const py::object& points, const py::object& faces,
                                         const py::object& labels, const py::object& face_sizes)
{
  const Soup soup = make_soup(points, faces, face_sizes);
  const Edges edges = edges_between_labels(soup, make_labels(soup, labels, "labels"));
  py::array_t<std::size_t> result({edges.size(), std::size_t(2)});
  for (std::size_t i = 0; i < edges.size(); ++i) {
    result.mutable_at(i, 0) = edges[i].first;
    result.mutable_at(i, 1) = edges[i].second;
  }
  return result;
}

py::list describe_segments(const py::object& points, const py::object& faces,
                           const py::object& labels, const py::object& face_sizes)
{
  const Soup soup = make_soup(points, faces, face_sizes);
  return describe(soup, make_labels(soup, labels, "labels"));
}

} // namespace

PYBIND11_MODULE(region_segmentation, module)
{
  module.doc() = "Segmentation of surface meshes. A mesh is an array of n x 3 points and faces: an "
                 "array of m x 3 (or more) indices of\n"
                 "points; a list of faces of different sizes; or all indices with face_sizes. Or "
                 "an object with vertices and faces. It need\n"
                 "not be manifold, oriented or connected.";
  module.attr("__version__") = CGAL_REGION_SEGMENTATION_VERSION;
  py::register_exception<RS::Invalid_input>(module, "InvalidInput", PyExc_ValueError).doc() =
    "A mesh that cannot be segmented, or contradicting seeds and constraints. It names the place.";
  const py::none none;

  module.def("segment", &segment,
             "The segment of each face, 0 to n - 1 in the order of their first faces.\n\n"
             "number_of_segments: None lets the method choose it; where it is not possible, there "
             "is a UserWarning.\n"
             "method: learned, visibility, two-step (needs a number) or smooth-faces. "
             "constrained_edges: an array of n x 2\n"
             "indices of points; these edges always are borders. seeds: an integer for each face, "
             "-1 for none; equal seeds end\n"
             "in one segment, different ones in different segments. component_links: whether "
             "components that touch or are\n"
             "near each other are adjacent.",
             py::arg("points"), py::arg("faces") = none, py::arg("number_of_segments") = none,
             py::arg("method") = "learned", py::arg("constrained_edges") = none,
             py::arg("seeds") = none, py::arg("component_links") = true,
             py::arg("face_sizes") = none);

  module.def("segment_borders", &segment_borders,
             "The edges between faces of different labels: an array of n x 2 indices of points.",
             py::arg("points"), py::arg("faces") = none, py::arg("labels"),
             py::arg("face_sizes") = none);
  module.def(
    "describe_segments", &describe_segments,
    "A dictionary for each segment, in the order of their first faces: segment, number_of_faces, "
    "area, volume,\n"
    "centroid, axes, extents, border_length, boundary_length; neighbors (segment, border_length,\n"
    "mean_signed_deviation); and primitive (type, point, direction, radius, half_angle, error). "
    "Faces of label -1\n"
    "belong to no segment. What is not manifold is torn apart there, before; faces with a point "
    "twice are counted, and\n"
    "have no area.",
    py::arg("points"), py::arg("faces") = none, py::arg("labels"), py::arg("face_sizes") = none);

  py::class_<Segmenter>(module, "Segmenter",
                        "A mesh that is prepared once, and segmented for any numbers.")
    .def(py::init<const py::object&, const py::object&, const std::string&, const py::object&,
                  const py::object&, bool, const py::object&>(),
         "Arguments as of the function segment.", py::arg("points"), py::arg("faces") = none,
         py::arg("method") = "learned", py::arg("constrained_edges") = none,
         py::arg("seeds") = none, py::arg("component_links") = true, py::arg("face_sizes") = none)
    .def(
      "segment",
      [](const Segmenter& segmenter, const py::object& number_of_segments) {
        return segmenter.segment(to_number_of_segments(number_of_segments));
      },
      "As the function of this name.", py::arg("number_of_segments") = none)
    .def("add_constraints", &Segmenter::add_constraints, "More constrained edges.",
         py::arg("constrained_edges"))
    .def("set_seeds", &Segmenter::set_seeds, "Replaces the seeds.", py::arg("seeds"))
    .def_property_readonly("regions", &Segmenter::regions,
                           "What segments consist of: the region of each face.")
    .def_property_readonly("merges", &Segmenter::merges,
                           "The merges of the regions: (kept, removed, cost), in order.");
}
