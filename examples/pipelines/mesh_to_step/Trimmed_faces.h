// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_TRIMMED_FACES_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_TRIMMED_FACES_H

#include "make_curve.h"
#include "part_surface.h"

#include <BRep_Builder.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>

#include <map>
#include <set>
#include <vector>

namespace mesh_to_step {

/// The faces to make, by label: faces of the part, and facets, which are planes.
struct Labelled_faces
{
  Labels labels; ///< of the triangles
  std::vector<Fitted_surface> surfaces;
  std::vector<bool> is_facet;
};

/// The diagonal of the bounding box.
double size_of(const Mesh& mesh);

/// Surfaces that are trimmed by the edges between the faces, which they share.
class Trimmed_faces
{
public:
  /// \param mesh closed
  Trimmed_faces(const Mesh& mesh, const Labelled_faces& faces);

  /// By label; null of a freeform face without a surface, several faces where seams divide one.
  const std::vector<TopoDS_Shape>& shapes() const { return m_shapes; }
  /// Whether a face is made, and has about the area of its triangles.
  bool is_right(std::size_t face) const;

private:
  using Halfedge = Mesh::Halfedge_index;
  using Halfedges = std::vector<Halfedge>;

  gp_Pnt source_point(Halfedge h) const { return point_of(m_mesh.point(source(h, m_mesh))); }
  std::size_t label(Halfedge h) const { return m_faces.labels[face(h, m_mesh)]; }
  bool is_freeform(std::size_t face) const
  {
    return m_faces.surfaces[face].kind == RS::Surface_kind::FREEFORM;
  }
  std::vector<Halfedges> loops(std::size_t face) const;
  Halfedge next_at_border(Halfedge h) const;
  Surfaces simple_surfaces(const std::set<std::size_t>& faces) const;
  Fitted_surface with_axis(std::size_t face) const;
  bool can_be_axis(const gp_Dir& axis, std::size_t face) const;

  void make_freeform_surface(std::size_t face);
  TopoDS_Vertex vertex(Mesh::Vertex_index v);
  void make_edges();
  void make_edge(const Halfedges& chain, bool is_closed);
  Surfaces surfaces_along(Halfedge h) const;
  double tolerance_along(Halfedge h) const;
  void add_parameter_curve(const TopoDS_Edge& edge, std::size_t face);
  TopoDS_Shape make_face(std::size_t face);
  void set_tolerances();

  const Mesh& m_mesh;
  const Labelled_faces& m_faces;
  double m_size;
  std::vector<std::vector<Mesh::Face_index>> m_triangles; ///< of each face
  std::vector<Halfedges> m_border_halfedges;              ///< of each face
  Surfaces m_surfaces;                                    ///< of each face, or null
  std::map<Mesh::Vertex_index, TopoDS_Vertex> m_vertices;
  std::map<Halfedge, TopoDS_Edge> m_edges;  ///< by the first halfedge in the face to their left
  std::map<Halfedge, Curve_piece> m_pieces; ///< along halfedges at borders
  std::vector<TopoDS_Shape> m_shapes;
  BRep_Builder m_builder;
  Handle(ShapeBuild_ReShape) m_context = new ShapeBuild_ReShape; ///< edges that seams divide
};

} // namespace mesh_to_step

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_TRIMMED_FACES_H
