// SPDX-License-Identifier: GPL-3.0-or-later

#include "cgal_methods.h"

#include <CGAL/Cartesian.h>
#include <CGAL/Monge_via_jet_fitting.h>

namespace speed_benchmark {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = Surface_mesh::Vertex_index;

/// The points of a vertex, first, and of those at most two edges away.
class Neighborhood
{
public:
  explicit Neighborhood(const Surface_mesh& mesh)
    : m_mesh(mesh)
    , m_visitor_of(mesh.number_of_vertices(), Surface_mesh::null_vertex())
  {}

  const std::vector<Kernel::Point_3>& points(Vertex center)
  {
    m_vertices.assign(1, center);
    m_visitor_of[center] = center;
    std::size_t begin = 0;
    for (int ring = 0; ring < 2; ++ring)
      for (const std::size_t end = m_vertices.size(); begin < end; ++begin)
        add_neighbors(m_vertices[begin], center);
    m_points.clear();
    for (Vertex v : m_vertices)
      m_points.push_back(m_mesh.point(v));
    return m_points;
  }

private:
  void add_neighbors(Vertex v, Vertex center)
  {
    for (auto h : CGAL::halfedges_around_target(v, m_mesh))
      if (const Vertex w = source(h, m_mesh); m_visitor_of[w] != center) {
        m_visitor_of[w] = center;
        m_vertices.push_back(w);
      }
  }

  const Surface_mesh& m_mesh;
  std::vector<Vertex> m_visitor_of, m_vertices;
  std::vector<Kernel::Point_3> m_points;
};

} // namespace

void principal_curvatures(const Surface_mesh& mesh, std::vector<double>& curvatures)
{
  Neighborhood neighborhood(mesh);
  for (Vertex v : vertices(mesh)) {
    const auto& points = neighborhood.points(v);
    CGAL::Monge_via_jet_fitting<Kernel> fitting;
    curvatures[v] = points.size() < 6 || CGAL::is_border(v, mesh)
                      ? 0
                      : fitting(points.begin(), points.end(), 2, 2).principal_curvatures(0);
  }
}

} // namespace speed_benchmark
