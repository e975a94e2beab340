// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MAKE_SURFACE_MESH_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MAKE_SURFACE_MESH_H

#include "soup/Polygon_soup.h"
#include "soup/link_corners.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace segment_mesh {

/// Connects the elements of a `Surface_mesh`, of which there are as many as are needed.
template <typename Mesh>
class Mesh_connector
{
  using Index = typename Mesh::size_type;
  using Halfedge = typename Mesh::Halfedge_index;
  using Vertex = typename Mesh::Vertex_index;
  using Face = typename Mesh::Face_index;

public:
  Mesh_connector(const Polygons& polygons, const Corner_links& links, Mesh& mesh)
    : m_corners(polygons.corners())
    , m_links(links)
    , m_mesh(mesh)
    , m_halfedge_from(links.size())
  {
    Index first = 0;
    for (const Face face : m_mesh.faces()) {
      const Index end = first + Index(polygons[face].size());
      add_halfedges(first, end);
      connect(face, first, end);
      first = end;
    }
    close_borders();
  }

private:
  /// Gives the corners of a face the halfedges that leave them. Across the edge to a corner is the
  /// halfedge that leaves the linked corner, which is known if it is of an earlier face.
  void add_halfedges(Index first, Index end)
  {
    Index previous = end - 1;
    for (Index corner = first; corner < end; previous = corner++) {
      const Index link = m_links[corner];
      const Halfedge h = link < first ? m_mesh.opposite(m_halfedge_from[link])
                                      : Halfedge(2 * m_number_of_edges++);
      m_halfedge_from[previous] = h;
      if (link == no_corner) {
        m_mesh.set_target(m_mesh.opposite(h), Vertex(m_corners[previous]));
        m_border.push_back(m_mesh.opposite(h));
      }
    }
  }

  void connect(Face face, Index first, Index end)
  {
    Halfedge h = m_halfedge_from[end - 1];
    m_mesh.set_halfedge(face, h);
    for (Index corner = first; corner < end; ++corner) {
      const Vertex target(m_corners[corner]);
      m_mesh.set_target(h, target);
      m_mesh.set_halfedge(target, h);
      m_mesh.set_face(h, face);
      m_mesh.set_next(h, m_halfedge_from[corner]);
      h = m_halfedge_from[corner];
    }
  }

  /// Of the halfedges without a face there is at most one to each vertex, and it is the one that
  /// the vertex keeps.
  void close_borders()
  {
    for (const Halfedge h : m_border)
      m_mesh.set_halfedge(m_mesh.target(h), h);
    for (const Halfedge h : m_border)
      m_mesh.set_next(m_mesh.halfedge(m_mesh.source(h)), h);
  }

  const std::vector<Index>& m_corners;
  const Corner_links& m_links;
  Mesh& m_mesh;
  std::vector<Halfedge> m_halfedge_from; // a corner
  std::vector<Halfedge> m_border;        // without a face
  Index m_number_of_edges = 0;
};

/// The mesh of a soup, whose faces and vertices have the indices that they have there.
///
/// \cgal's `polygon_soup_to_polygon_mesh()`, which keeps the mesh valid after every face, takes 2.1
/// to 2.7 times as long (1 and 10 million triangles), longer than segmenting by two-step. \pre
/// `links` are those of the soup
template <typename Mesh>
Mesh make_surface_mesh(const Polygon_soup& soup, const Corner_links& links)
{
  const std::size_t number_of_border_edges = std::size_t(
    std::count(links.begin(), links.end(), no_corner));
  using Index = typename Mesh::size_type;
  Mesh mesh;
  mesh.resize(Index(soup.points.size()), Index((links.size() + number_of_border_edges) / 2),
              Index(soup.polygons.size()));
  for (const auto v : mesh.vertices()) {
    const Point& p = soup.points[v];
    mesh.point(v) = {p[0], p[1], p[2]};
  }
  Mesh_connector<Mesh>(soup.polygons, links, mesh);
  return mesh;
}

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MAKE_SURFACE_MESH_H
