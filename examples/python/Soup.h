// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PYTHON_SOUP_H
#define CGAL_REGION_SEGMENTATION_PYTHON_SOUP_H

#include "soup/Polygon_soup.h"

#include <pybind11/numpy.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

using Soup = segment_mesh::Polygon_soup;
using Indices = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;
using Edges = std::vector<std::pair<std::size_t, std::size_t>>;

/// An array of integers of any width and order.
/// \throws pybind11::type_error that says `expected` if it is none
Indices to_indices(const py::handle& object, const std::string& expected);

/// `points`: n x 3 numbers, or an object with `vertices` and `faces`. `faces`: m x c integers; a
/// sequence of sequences of integers; or all corners one after another, of which `face_sizes` says
/// how many belong to each face. \throws pybind11::type_error or std::invalid_argument that says
/// what was expected
Soup make_soup(const py::object& points, const py::object& faces, const py::object& face_sizes);

/// An integer for each face.
/// \throws pybind11::type_error or std::invalid_argument that begins with `name`
std::vector<std::int64_t> make_labels(const Soup& soup, const py::object& labels,
                                      const std::string& name);

/// The edges between the points of each row.
/// \throws std::invalid_argument for a pair that is no edge
Edges make_edges(const Soup& soup, const py::object& edges);

/// The edges whose faces have several labels; lower points first, in ascending order.
Edges edges_between_labels(const Soup& soup, const std::vector<std::int64_t>& labels);

#endif // CGAL_REGION_SEGMENTATION_PYTHON_SOUP_H
