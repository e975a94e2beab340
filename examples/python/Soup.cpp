// SPDX-License-Identifier: GPL-3.0-or-later

#include "Soup.h"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace {

using segment_mesh::Point;
using segment_mesh::Polygons;

void check(bool is_right, const std::string& what)
{
  if (!is_right)
    throw std::invalid_argument(what);
}

std::vector<Point> to_points(const py::object& object)
{
  const std::string expected = "points: not an array of n x 3 numbers";
  const py::array any = py::array::ensure(object);
  if (!any || std::string("fiu").find(any.dtype().kind()) == std::string::npos)
    throw py::type_error(expected);
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(any);
  check(array && array.ndim() == 2 && array.shape(1) == 3, expected);
  std::vector<Point> points;
  points.reserve(std::size_t(array.shape(0)));
  for (py::ssize_t i = 0; i < array.shape(0); ++i)
    points.push_back({array.at(i, 0), array.at(i, 1), array.at(i, 2)});
  return points;
}

/// Fills polygons, whose corners are to be indices of points.
class Polygon_writer
{
public:
  Polygon_writer(Polygons& polygons, std::size_t number_of_points)
    : m_polygons(polygons)
    , m_number(number_of_points)
  {}

  void add(const std::int64_t* begin, const std::int64_t* end)
  {
    for (const std::int64_t* i = begin; i != end; ++i) {
      check(*i >= 0 && std::uint64_t(*i) < m_number,
            "face " + std::to_string(m_polygons.size()) + ", from 0: index " + std::to_string(*i) +
              " is out of range: there are " + std::to_string(m_number) + " points");
      m_polygons.add_corner(std::size_t(*i));
    }
    check(begin != end, "face " + std::to_string(m_polygons.size()) + ", from 0: has no corners");
    m_polygons.close_polygon();
  }

private:
  Polygons& m_polygons;
  std::size_t m_number;
};

const char* const expected_faces =
  "faces: not an array of m x 3 indices, or more columns, nor a sequence of faces, each a "
  "sequence of indices, nor all indices with face_sizes";

void add_rows(const Indices& faces, Polygon_writer& writer)
{
  check(faces.shape(1) >= 3, expected_faces);
  for (py::ssize_t f = 0; f < faces.shape(0); ++f)
    writer.add(faces.data(f, 0), faces.data(f, 0) + faces.shape(1));
}

void add_with_sizes(const Indices& corners, const Indices& sizes, Polygon_writer& writer)
{
  check(corners.ndim() == 1 && sizes.ndim() == 1,
        "faces with face_sizes: not two arrays of one dimension");
  const std::int64_t *corner = corners.data(), *end = corner + corners.size();
  for (py::ssize_t f = 0; f < sizes.size(); ++f) {
    check(sizes.at(f) >= 0 && sizes.at(f) <= end - corner,
          "face_sizes: their sum is not the number of indices");
    writer.add(corner, corner + sizes.at(f));
    corner += sizes.at(f);
  }
  check(corner == end, "face_sizes: their sum is not the number of indices");
}

/// Faces of different sizes make no array.
bool is_ragged(const py::object& faces)
{
  if (py::isinstance<py::array>(faces) || !py::isinstance<py::sequence>(faces) ||
      py::len(faces) == 0)
    return false;
  const auto size = [](const py::handle& face) {
    return py::isinstance<py::sequence>(face) || py::isinstance<py::array>(face) ? py::len(face)
                                                                                 : 0;
  };
  const std::size_t first = size(faces[py::int_(0)]);
  for (const py::handle face : faces)
    if (size(face) != first)
      return true;
  return false;
}

/// The first of the points at the same place, for each point.
std::vector<std::size_t> equal_points(const Soup& soup)
{
  std::map<Point, std::size_t> first;
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    result.push_back(first.emplace(soup.points[i], i).first->second);
  return result;
}

using Side = std::pair<Edges::value_type, std::size_t>; // lower and higher point, face

std::vector<Side> sorted_sides(const Soup& soup, const std::vector<std::size_t>& merged)
{
  std::vector<Side> sides;
  for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
    const Polygons::Polygon polygon = soup.polygons[f];
    for (std::size_t i = 0; i < polygon.size(); ++i)
      sides.push_back(
        {std::minmax({merged[polygon[i]], merged[polygon[(i + 1) % polygon.size()]]}), f});
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

} // namespace

Indices to_indices(const py::handle& object, const std::string& expected)
{
  const py::array any = py::array::ensure(object);
  if (!any || std::string("iu").find(any.dtype().kind()) == std::string::npos)
    throw py::type_error(expected);
  return Indices::ensure(any);
}

Soup make_soup(const py::object& points, const py::object& faces, const py::object& face_sizes)
{
  if (faces.is_none()) {
    if (!py::hasattr(points, "vertices") || !py::hasattr(points, "faces"))
      throw py::type_error("a mesh: not points and faces, nor an object with vertices and faces");
    return make_soup(points.attr("vertices"), points.attr("faces"), face_sizes);
  }
  Soup soup;
  soup.points = to_points(points);
  // An empty list is an array that does not say that it holds integers.
  if (face_sizes.is_none() && py::isinstance<py::sequence>(faces) && py::len(faces) == 0)
    return soup;
  Polygon_writer writer(soup.polygons, soup.points.size());
  if (!face_sizes.is_none())
    add_with_sizes(to_indices(faces, expected_faces),
                   to_indices(face_sizes, "face_sizes: not an array of integers"), writer);
  else if (is_ragged(faces))
    for (const py::handle face : faces) {
      const Indices corners = to_indices(face, expected_faces);
      check(corners.ndim() == 1, expected_faces);
      writer.add(corners.data(), corners.data() + corners.size());
    }
  else {
    const Indices rows = to_indices(faces, expected_faces);
    check(rows.ndim() == 2, expected_faces);
    add_rows(rows, writer);
  }
  return soup;
}

std::vector<std::int64_t> make_labels(const Soup& soup, const py::object& labels,
                                      const std::string& name)
{
  const std::string expected = name + ": not an integer for each face, -1 for none";
  const Indices array = to_indices(labels, expected);
  check(array.ndim() == 1 && std::size_t(array.size()) == soup.polygons.size(), expected);
  return {array.data(), array.data() + array.size()};
}

Edges make_edges(const Soup& soup, const py::object& edges)
{
  const char* const expected = "constrained_edges: not an array of n x 2 indices";
  const Indices array = to_indices(edges, expected);
  check(array.ndim() == 2 && array.shape(1) == 2, expected);
  const std::vector<std::size_t> merged = equal_points(soup);
  const std::vector<Side> sides = sorted_sides(soup, merged);
  const auto is_point = [&](std::int64_t v) { return v >= 0 && std::uint64_t(v) < merged.size(); };
  const auto is_edge = [&](std::size_t a, std::size_t b) {
    const auto edge = std::minmax({merged[a], merged[b]});
    const auto i = std::lower_bound(sides.begin(), sides.end(), Side{edge, 0});
    return i != sides.end() && i->first == Edges::value_type(edge);
  };
  Edges result;
  for (py::ssize_t i = 0; i < array.shape(0); ++i) {
    const std::int64_t a = array.at(i, 0), b = array.at(i, 1);
    check(is_point(a) && is_point(b) && is_edge(std::size_t(a), std::size_t(b)),
          "constrained_edges: there is no edge between points " + std::to_string(a) + " and " +
            std::to_string(b));
    result.emplace_back(a, b);
  }
  return result;
}

Edges edges_between_labels(const Soup& soup, const std::vector<std::int64_t>& labels)
{
  Edges result;
  const std::vector<Side> sides = sorted_sides(soup, equal_points(soup));
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
    if (sides[i].first == sides[i + 1].first &&
        labels[sides[i].second] != labels[sides[i + 1].second] &&
        (result.empty() || result.back() != sides[i].first))
      result.push_back(sides[i].first);
  return result;
}
