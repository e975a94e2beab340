// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PYTHON_SOUP_H
#define CGAL_REGION_SEGMENTATION_PYTHON_SOUP_H

#include <pybind11/numpy.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

using Point = std::array<double, 3>;
using Indices = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;
using Edges = std::vector<std::pair<std::size_t, std::size_t>>;

/// Faces, all corners one after another: a range of ranges.
class Polygons
{
public:
  struct Polygon
  {
    const std::size_t *first, *last;
    const std::size_t* begin() const { return first; }
    const std::size_t* end() const { return last; }
    std::size_t size() const { return std::size_t(last - first); }
  };

  class const_iterator
  {
  public:
    using iterator_category = std::input_iterator_tag; // since polygons are values
    using value_type = Polygon;
    using difference_type = std::ptrdiff_t;
    using pointer = const Polygon*;
    using reference = Polygon;

    const_iterator(const Polygons& polygons, std::size_t f) : m_polygons(&polygons), m_f(f) {}
    Polygon operator*() const { return (*m_polygons)[m_f]; }
    const_iterator& operator++() { return ++m_f, *this; }
    const_iterator operator++(int) { return {*m_polygons, m_f++}; }
    friend bool operator==(const const_iterator& a, const const_iterator& b) { return a.m_f == b.m_f; }
    friend bool operator!=(const const_iterator& a, const const_iterator& b) { return a.m_f != b.m_f; }

  private:
    const Polygons* m_polygons;
    std::size_t m_f;
  };
  using iterator = const_iterator;
  using value_type = Polygon;

  std::size_t size() const { return m_ends.size(); }
  Polygon operator[](std::size_t f) const
  {
    return {m_corners.data() + (f == 0 ? 0 : m_ends[f - 1]), m_corners.data() + m_ends[f]};
  }
  const_iterator begin() const { return {*this, 0}; }
  const_iterator end() const { return {*this, size()}; }

  void add_corner(std::size_t point) { m_corners.push_back(point); }
  void close_polygon() { m_ends.push_back(m_corners.size()); }

private:
  std::vector<std::size_t> m_corners, m_ends;
};

/// A mesh as a user of Python has it.
struct Soup
{
  std::vector<Point> points;
  Polygons polygons;
};

/// An array of integers of any width and order.
/// \throws pybind11::type_error that says `expected` if it is none
Indices to_indices(const py::handle& object, const std::string& expected);

/// `points`: n x 3 numbers, or an object with `vertices` and `faces`. `faces`: m x c integers; a sequence of sequences of
/// integers; or all corners one after another, of which `face_sizes` says how many belong to each face.
/// \throws pybind11::type_error or std::invalid_argument that says what was expected
Soup make_soup(const py::object& points, const py::object& faces, const py::object& face_sizes);

/// The edges between the points of each row.
/// \throws std::invalid_argument for a pair that is no edge
Edges make_edges(const Soup& soup, const py::object& edges);

#endif // CGAL_REGION_SEGMENTATION_PYTHON_SOUP_H
