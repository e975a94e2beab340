// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PYTHON_NUMPY_MESH_H
#define CGAL_REGION_SEGMENTATION_PYTHON_NUMPY_MESH_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/property_map/property_map.hpp>

#include <pybind11/numpy.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

/// Arrays of doubles and of indices, row by row. Others are converted, which is the only copy that is ever made of points.
using Points = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;
using Indices = pybind11::array_t<std::int64_t, pybind11::array::c_style>;

/// The connectivity of an array of faces; points stay where they are.
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

/// Reads points from an array of n x 3 doubles.
struct Point_map
{
  using key_type = Mesh::Vertex_index;
  using value_type = CGAL::Simple_cartesian<double>::Point_3;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  const double* coordinates;

  friend value_type get(const Point_map& map, key_type v)
  {
    const double* const p = map.coordinates + 3 * std::size_t(v);
    return {p[0], p[1], p[2]};
  }
};

inline void check_shape(bool is_right, const char* what)
{
  if (!is_right)
    throw std::invalid_argument(what);
}

/// \throws std::invalid_argument naming the face that is none, or that would not leave an oriented 2-manifold
inline Mesh make_mesh(const Points& points, const Indices& faces)
{
  check_shape(points.ndim() == 2 && points.shape(1) == 3, "points: not an array of n x 3 numbers");
  check_shape(faces.ndim() == 2 && faces.shape(1) >= 3, "faces: not an array of m x 3 indices, or more columns");
  const std::int64_t number_of_points = points.shape(0);
  Mesh mesh;
  mesh.reserve(Mesh::size_type(number_of_points), Mesh::size_type(faces.size()), Mesh::size_type(faces.shape(0)));
  mesh.resize(Mesh::size_type(number_of_points), 0, 0);
  std::vector<Mesh::Vertex_index> corners(std::size_t(faces.shape(1)));
  for (pybind11::ssize_t f = 0; f < faces.shape(0); ++f) {
    const std::int64_t* const row = faces.data(f, 0);
    const std::string name = "face " + std::to_string(f) + ", from 0: ";
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (row[i] < 0 || row[i] >= number_of_points)
        throw std::invalid_argument(name + "index " + std::to_string(row[i]) + " is out of range: there are " +
                                    std::to_string(number_of_points) + " points");
      if (std::find(row, row + i, row[i]) != row + i)
        throw std::invalid_argument(name + "point " + std::to_string(row[i]) + " is there twice");
      corners[i] = Mesh::Vertex_index(Mesh::size_type(row[i]));
    }
    if (!CGAL::Euler::can_add_face(corners, mesh))
      throw std::invalid_argument(name + "the faces up to this one are not an oriented 2-manifold");
    CGAL::Euler::add_face(corners, mesh);
  }
  return mesh;
}

/// The edges between the points of each row.
/// \throws std::invalid_argument for a pair that is no edge
inline std::vector<bool> marked_edges(const Mesh& mesh, const Indices& edges)
{
  check_shape(edges.ndim() == 2 && edges.shape(1) == 2, "constrained_edges: not an array of n x 2 indices");
  std::vector<bool> marks(mesh.number_of_edges());
  const std::int64_t number_of_points = mesh.number_of_vertices();
  for (pybind11::ssize_t i = 0; i < edges.shape(0); ++i) {
    const std::int64_t a = edges.at(i, 0), b = edges.at(i, 1);
    const bool is_in_range = a >= 0 && b >= 0 && a < number_of_points && b < number_of_points;
    const auto h = is_in_range ? mesh.halfedge(Mesh::Vertex_index(Mesh::size_type(a)), Mesh::Vertex_index(Mesh::size_type(b)))
                               : Mesh::null_halfedge();
    if (h == Mesh::null_halfedge())
      throw std::invalid_argument("constrained_edges: there is no edge between points " + std::to_string(a) + " and " +
                                  std::to_string(b));
    marks[mesh.edge(h)] = true;
  }
  return marks;
}

#endif // CGAL_REGION_SEGMENTATION_PYTHON_NUMPY_MESH_H
