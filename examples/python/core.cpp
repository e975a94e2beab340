// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The compiled part of the Python package: region_segmentation/__init__.py calls it with arrays of
// one form.

#include "core.h"

#include "segmentation/Any_segmenter.h"
#include "soup/make_soup.h"
#include "view/segment_colors.h"

#include <CGAL/Region_segmentation/Support/version.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace RS = CGAL::Region_segmentation;

namespace {

class Segmenter
{
public:
  Segmenter(const Soup& soup, const std::string& method, double tolerance,
            const Array<std::int64_t>& edges, const Array<std::int32_t>& seeds,
            bool component_links, int threads, const py::object& progress)
    : m_size(soup.polygons.size())
    , m_progress(progress)
    , m_segmenter([&] {
      const auto constraints = make_edges(soup, to_vector(edges));
      const Labels seed_of_face = to_vector(seeds);
      return run(threads, progress, [&](Visitor& visitor) {
        return segment_mesh::Any_segmenter(method, tolerance, soup,
                                           RS::parameters::component_links(component_links)
                                             .constrained_edges(constraints)
                                             .face_seed_map(seed_of_face)
                                             .visitor(std::ref(visitor)));
      });
    }())
  {}

  Array<std::int32_t> segment(std::optional<std::size_t> number_of_segments) const
  {
    Labels labels(m_size);
    run(1, m_progress, [&](Visitor& visitor) {
      m_segmenter.segment(number_of_segments, labels, RS::parameters::visitor(std::ref(visitor)));
    });
    return to_array(labels);
  }

  Array<std::int32_t> regions() const
  {
    Labels labels;
    m_segmenter.with_tree("has no regions for all numbers", [&](const auto& segmenter) {
      labels.assign(segmenter.regions().begin(), segmenter.regions().end());
    });
    return to_array(labels);
  }

  py::list merges() const
  {
    py::list result;
    m_segmenter.with_tree("has no tree for all numbers", [&](const auto& segmenter) {
      for (const RS::Merge_tree::Merge& merge : segmenter.merge_tree().merges())
        result.append(
          py::make_tuple(std::size_t(merge.kept), std::size_t(merge.removed), merge.cost));
    });
    return result;
  }

private:
  std::size_t m_size;
  py::object m_progress;
  segment_mesh::Any_segmenter m_segmenter;
};

/// Two points of each edge, in ascending order.
Array<std::size_t> segment_borders(const Soup& soup, const Array<std::int32_t>& labels)
{
  std::vector<std::size_t> ends;
  for (const auto& [a, b] : segment_mesh::borders_of_labels(soup, labels.data()))
    ends.insert(ends.end(), {a, b});
  return to_array(ends);
}

/// Three bytes a face.
Array<std::uint8_t> colors(const Array<std::int32_t>& labels)
{
  std::vector<std::uint8_t> result;
  for (const std::int32_t label : to_vector(labels))
    for (const std::uint8_t channel : segment_mesh::segment_color(std::size_t(label)))
      result.push_back(channel);
  return to_array(result);
}

} // namespace

PYBIND11_MODULE(_core, module)
{
  module.attr("__version__") = CGAL_REGION_SEGMENTATION_VERSION;
  py::register_exception<RS::Invalid_input>(module, "InvalidInput", PyExc_ValueError).doc() =
    "A mesh that cannot be segmented, or contradicting seeds and constraints. It names the place.";
  py::register_exception<RS::Segmentation_cancelled>(module, "Cancelled", PyExc_RuntimeError)
    .doc() = "The function progress has returned False.";

  py::class_<Soup>(module, "Soup")
    .def(py::init([](const Array<double>& points, const Array<std::int64_t>& corners,
                     const Array<std::int64_t>& sizes) {
      return segment_mesh::make_soup(to_vector(points), to_vector(corners), to_vector(sizes));
    }))
    .def("__len__", [](const Soup& soup) { return soup.polygons.size(); });

  py::class_<Segmenter>(module, "Segmenter")
    .def(py::init<const Soup&, const std::string&, double, const Array<std::int64_t>&,
                  const Array<std::int32_t>&, bool, int, const py::object&>())
    .def("segment", &Segmenter::segment)
    .def("regions", &Segmenter::regions)
    .def("merges", &Segmenter::merges);

  module.def("segment_borders", &segment_borders);
  module.def("colors", &colors);
  define_functions_of_segments(module);
}
