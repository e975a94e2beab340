// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_BENCHMARK_MESH_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_BENCHMARK_MESH_H

#include "soup/Polygon_soup.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <stdexcept>
#include <vector>

namespace princeton_benchmark {

/// Faces and vertices are numbered as in the file.
using Benchmark_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

/// A map of the faces to a vector of labels.
template <typename Labels>
auto face_map(const Benchmark_mesh& mesh, Labels& labels)
{
  return boost::make_iterator_property_map(labels.begin(), get(boost::face_index, mesh));
}

/// \throws std::runtime_error if the soup is not an oriented 2-manifold
inline Benchmark_mesh make_mesh(const segment_mesh::Polygon_soup& soup)
{
  Benchmark_mesh mesh;
  for (const segment_mesh::Point& p : soup.points)
    mesh.add_vertex({p[0], p[1], p[2]});
  std::vector<Benchmark_mesh::Vertex_index> corners;
  for (const auto& polygon : soup.polygons) {
    corners.clear();
    for (std::size_t i : polygon)
      corners.emplace_back(Benchmark_mesh::size_type(i));
    if (mesh.add_face(corners) == Benchmark_mesh::null_face())
      throw std::runtime_error("not an oriented 2-manifold");
  }
  return mesh;
}

} // namespace princeton_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_ACCURACY_BENCHMARK_MESH_H
