// SPDX-License-Identifier: GPL-3.0-or-later
//
// A Python module: points and faces as NumPy arrays in, labels out.

#include "Numpy_mesh.h"

#include <CGAL/Region_segmentation/Methods/Learned_merging.h>
#include <CGAL/Region_segmentation/Methods/Smooth_faces.h>
#include <CGAL/Region_segmentation/Methods/Two_step.h>
#include <CGAL/Region_segmentation/Methods/Visibility_merging.h>
#include <CGAL/Region_segmentation/Segmenter.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <type_traits>

namespace py = pybind11;
namespace RS = CGAL::Region_segmentation;

namespace {

using Labels = py::array_t<std::size_t>;

/// A mesh prepared by one of the methods.
class Prepared
{
public:
  virtual ~Prepared() = default;
  /// Writes the label of each face; without a number the method chooses one.
  virtual void write_labels(std::optional<std::size_t> number_of_segments, std::size_t* labels) const = 0;
};

template <typename Method>
class Prepared_by : public Prepared
{
public:
  template <typename NamedParameters>
  Prepared_by(const Mesh& mesh, const NamedParameters& np)
    : m_segmenter(mesh, np.method(Method()))
  {}

  void write_labels(std::optional<std::size_t> number_of_segments, std::size_t* labels) const override
  {
    const auto map = boost::make_iterator_property_map(labels, get(boost::face_index, m_segmenter.mesh()));
    if (number_of_segments)
      m_segmenter.segment(map, *number_of_segments);
    else if constexpr (std::is_same<Method, RS::Two_step>::value)
      throw std::invalid_argument("method two-step needs number_of_segments");
    else
      m_segmenter.segment(map);
  }

private:
  RS::Segmenter<Mesh, Method> m_segmenter;
};

/// The class of the module. It keeps the mesh; the array of points is read by the constructor only.
class Segmenter
{
public:
  Segmenter(const Points& points, const Indices& faces, const std::string& method,
            const std::optional<Indices>& constrained_edges)
    : m_mesh(make_mesh(points, faces))
  {
    std::vector<bool> marks(m_mesh.number_of_edges());
    if (constrained_edges)
      marks = marked_edges(m_mesh, *constrained_edges);
    const Point_map point_map{points.data()};
    const py::gil_scoped_release release;
    const auto np = RS::parameters::vertex_point_map(point_map).edge_is_constrained_map(
      boost::make_iterator_property_map(marks.begin(), get(boost::edge_index, m_mesh)));
    if (method == "learned")
      m_prepared = std::make_unique<Prepared_by<RS::Learned_merging>>(m_mesh, np);
    else if (method == "visibility")
      m_prepared = std::make_unique<Prepared_by<RS::Visibility_merging>>(m_mesh, np);
    else if (method == "two-step")
      m_prepared = std::make_unique<Prepared_by<RS::Two_step>>(m_mesh, np);
    else if (method == "smooth-faces")
      m_prepared = std::make_unique<Prepared_by<RS::Smooth_faces>>(m_mesh, np);
    else
      throw std::invalid_argument("method: not learned, visibility, two-step or smooth-faces");
  }

  Labels segment(std::optional<std::size_t> number_of_segments) const
  {
    check_shape(number_of_segments != std::size_t(0), "number_of_segments: at least 1");
    Labels labels{py::ssize_t(m_mesh.number_of_faces())};
    std::size_t* const values = labels.mutable_data();
    const py::gil_scoped_release release;
    m_prepared->write_labels(number_of_segments, values);
    return labels;
  }

private:
  const Mesh m_mesh;
  std::unique_ptr<const Prepared> m_prepared;
};

Labels segment(const Points& points, const Indices& faces, std::optional<std::size_t> number_of_segments,
               const std::string& method, const std::optional<Indices>& constrained_edges)
{
  return Segmenter(points, faces, method, constrained_edges).segment(number_of_segments);
}

} // namespace

PYBIND11_MODULE(region_segmentation, module)
{
  module.doc() = "Segmentation of surface meshes. A mesh is an array of n x 3 points, and an array of m x 3 (or more) "
                 "indices of points, the faces: an oriented 2-manifold with or without boundary.";
  py::register_exception<RS::Invalid_input>(module, "InvalidInput", PyExc_ValueError);

  module.def("segment", &segment,
             "The segment of each face, 0 to n - 1 in the order of their first faces.\n\n"
             "number_of_segments: None lets the method choose it. method: learned, visibility, two-step (needs a number)\n"
             "or smooth-faces. constrained_edges: an array of n x 2 indices of points; these edges always are borders.",
             py::arg("points"), py::arg("faces"), py::arg("number_of_segments") = py::none(),
             py::arg("method") = "learned", py::arg("constrained_edges") = py::none());

  py::class_<Segmenter>(module, "Segmenter", "A mesh that is prepared once, and segmented for any numbers.")
    .def(py::init<const Points&, const Indices&, const std::string&, const std::optional<Indices>&>(), py::arg("points"),
         py::arg("faces"), py::arg("method") = "learned", py::arg("constrained_edges") = py::none())
    .def("segment", &Segmenter::segment, "As the function of this name.", py::arg("number_of_segments") = py::none());
}
