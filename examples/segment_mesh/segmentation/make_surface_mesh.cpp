// SPDX-License-Identifier: GPL-3.0-or-later

#include "segmentation/make_surface_mesh.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace segment_mesh {

namespace {

using Index = Surface_mesh::size_type;
using Halfedge = Surface_mesh::Halfedge_index;
using Vertex = Surface_mesh::Vertex_index;

constexpr Index none = (std::numeric_limits<Index>::max)();

/// Builds the connectivity of a mesh that is known to be an oriented 2-manifold.
class Connector
{
public:
  /// The mesh has its vertices and faces, and as many edges as it would have without borders.
  explicit Connector(Surface_mesh& mesh) : m_mesh(mesh), m_first_edges(mesh.number_of_vertices(), none)
  {
    m_edges.reserve(mesh.number_of_edges());
  }

  void connect(Surface_mesh::Face_index face, const Polygon_soup::Polygon& polygon)
  {
    const Halfedge first = add_halfedge(Index(polygon.back()), Index(polygon.front()));
    m_mesh.set_halfedge(face, first);
    Halfedge previous = first;
    for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
      const Halfedge h = add_halfedge(Index(polygon[i]), Index(polygon[i + 1]));
      m_mesh.set_next(previous, h);
      m_mesh.set_face(h, face);
      previous = h;
    }
    m_mesh.set_next(previous, first);
    m_mesh.set_face(first, face);
  }

  /// Links the halfedges without a face. There is at most one from each vertex, and it is the one that the vertex keeps.
  void close_borders()
  {
    std::vector<Index>& border_from = m_first_edges;
    std::fill(border_from.begin(), border_from.end(), none);
    for (const Halfedge h : m_mesh.halfedges())
      if (m_mesh.is_border(h)) {
        border_from[m_mesh.source(h)] = Index(h);
        m_mesh.set_halfedge(m_mesh.target(h), h);
      }
    for (const Index first : border_from)
      if (first != none)
        m_mesh.set_next(Halfedge(first), Halfedge(border_from[m_mesh.target(Halfedge(first))]));
  }

private:
  /// An edge in the list of its vertex of lower index.
  struct Edge
  {
    Index higher_vertex, next;
  };

  /// From one vertex to another: the second halfedge of an edge that is there, or the first one of a new edge.
  Halfedge add_halfedge(Index source, Index target)
  {
    const Index lower = (std::min)(source, target), higher = (std::max)(source, target);
    Index edge = m_first_edges[lower];
    while (edge != none && m_edges[edge].higher_vertex != higher)
      edge = m_edges[edge].next;
    if (edge != none)
      return m_mesh.opposite(m_mesh.halfedge(Surface_mesh::Edge_index(edge)));
    m_edges.push_back({higher, m_first_edges[lower]});
    m_first_edges[lower] = Index(m_edges.size() - 1);
    const Halfedge h = new_edge();
    m_mesh.set_target(h, Vertex(target));
    m_mesh.set_target(m_mesh.opposite(h), Vertex(source));
    m_mesh.set_halfedge(Vertex(target), h);
    m_mesh.set_halfedge(Vertex(source), m_mesh.opposite(h));
    return h;
  }

  /// The first halfedge of the last one of `m_edges`.
  Halfedge new_edge()
  {
    return m_edges.size() > m_mesh.number_of_edges()
             ? m_mesh.add_edge()
             : m_mesh.halfedge(Surface_mesh::Edge_index(Index(m_edges.size() - 1)));
  }

  Surface_mesh& m_mesh;
  std::vector<Index> m_first_edges; // of each vertex
  std::vector<Edge> m_edges;
};

} // namespace

Surface_mesh make_surface_mesh(const Polygon_soup& soup)
{
  std::size_t number_of_corners = 0;
  for (const Polygon_soup::Polygon& polygon : soup.polygons)
    number_of_corners += polygon.size();

  Surface_mesh mesh;
  mesh.resize(Index(soup.points.size()), Index(number_of_corners / 2), Index(soup.polygons.size()));
  for (const Vertex v : mesh.vertices()) {
    const Point& p = soup.points[v];
    mesh.point(v) = {p[0], p[1], p[2]};
  }
  Connector connector(mesh);
  for (const Surface_mesh::Face_index face : mesh.faces())
    connector.connect(face, soup.polygons[face]);
  connector.close_borders();
  return mesh;
}

} // namespace segment_mesh
