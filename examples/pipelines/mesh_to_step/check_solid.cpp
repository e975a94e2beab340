// SPDX-License-Identifier: GPL-3.0-or-later

#include "check_solid.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/boost/graph/iterator.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <map>

namespace mesh_to_step {

namespace {

using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

/// The faces of a shape, in its order.
std::vector<TopoDS_Face> faces_of(const TopoDS_Shape& shape)
{
  std::vector<TopoDS_Face> result;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
    result.push_back(TopoDS::Face(face.Current()));
  return result;
}

/// Whether each edge of each shell is in two faces, or twice in one, in opposite directions.
bool has_closed_shells(const TopoDS_Shape& shape)
{
  for (TopExp_Explorer shell(shape, TopAbs_SHELL); shell.More(); shell.Next())
    if (!BRep_Tool::IsClosed(shell.Current()))
      return false;
  return true;
}

/// The largest distance from points of the edges of a face to its surface.
double distance_of_edges(const TopoDS_Face& face, const Surfaces& surface)
{
  double result = 0;
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
    Curve_piece piece;
    piece.curve = BRep_Tool::Curve(TopoDS::Edge(edges.Current()), piece.first, piece.last);
    if (piece.curve.IsNull())
      continue;
    const auto spline = Handle(Geom_BSplineCurve)::DownCast(piece.curve);
    result = (std::max)(result, gap(piece, surface, spline.IsNull() ? 12 : 3 * spline->NbKnots()));
  }
  return result;
}

/// A face, and the triangles that it is to be compared with.
class Comparison
{
public:
  Comparison(const Solid& solid, const std::vector<Mesh::Face_index>& triangles,
             const TopoDS_Face& face, const Surfaces& surface, const Surfaces& surface_of_label,
             const Tree& tree)
    : m_solid(solid)
    , m_mesh(solid.mesh)
    , m_triangles(triangles)
    , m_face(face)
    , m_surface(surface)
    , m_surface_of_label(surface_of_label)
    , m_tree(tree)
  {}

  /// All errors but those of edges.
  Face_errors run() const
  {
    Face_errors result;
    for (auto f : m_triangles) {
      Kernel::Vector_3 sum = CGAL::NULL_VECTOR;
      for (auto h : halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
        const Point &a = m_mesh.point(source(h, m_mesh)), &b = m_mesh.point(target(h, m_mesh));
        sum += a - CGAL::ORIGIN;
        include(result.of_vertices, a, m_surface);
        include(result.of_sides, CGAL::midpoint(a, b), surfaces_beside(h));
      }
      include(result.of_sides, CGAL::ORIGIN + sum / 3, m_surface);
    }
    result.of_surface = distance_to_triangles();
    return result;
  }

private:
  static void include(double& farthest, const Point& p, const Surfaces& surfaces)
  {
    farthest = (std::max)(farthest, distance(surfaces, point_of(p)));
  }

  /// The surfaces of the faces to both sides of a halfedge.
  Surfaces surfaces_beside(Mesh::Halfedge_index h) const
  {
    Surfaces result = m_surface;
    const std::size_t label = m_solid.labels[face(opposite(h, m_mesh), m_mesh)];
    if (const auto& other = m_surface_of_label[label]; !other.IsNull())
      result.push_back(other);
    return result;
  }

  /// The largest distance from vertices of a triangulation of the face to the mesh; 0 if it has
  /// none.
  double distance_to_triangles() const
  {
    TopLoc_Location place;
    const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(m_face, place);
    double farthest = 0;
    for (int i = 1; !triangulation.IsNull() && i <= triangulation->NbNodes(); ++i) {
      const gp_Pnt p = triangulation->Node(i).Transformed(place);
      farthest = (std::max)(farthest, m_tree.squared_distance({p.X(), p.Y(), p.Z()}));
    }
    return std::sqrt(farthest);
  }

  const Solid& m_solid;
  const Mesh& m_mesh;
  const std::vector<Mesh::Face_index>& m_triangles;
  const TopoDS_Face& m_face;
  const Surfaces& m_surface;
  const Surfaces& m_surface_of_label;
  const Tree& m_tree;
};

/// Measures a shape, but for its faces.
Certificate measure(const TopoDS_Shape& shape)
{
  constexpr double precision = 1e-5; // of area and volume
  Certificate result;
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
    ++result.number_of_solids;
  result.is_closed = result.number_of_solids > 0 && has_closed_shells(shape);
  result.is_valid = !shape.IsNull() && BRepCheck_Analyzer(shape).IsValid();
  GProp_GProps volume, area;
  BRepGProp::VolumeProperties(shape, volume, precision);
  BRepGProp::SurfaceProperties(shape, area, precision);
  result.volume = volume.Mass();
  result.area = area.Mass();
  return result;
}

} // namespace

Certificate compare(const TopoDS_Shape& shape, const Solid& solid)
{
  constexpr double deflection = 1e-3, angle = 0.3;
  Certificate result = measure(shape);
  const std::vector<TopoDS_Face> faces = faces_of(shape);
  result.number_of_faces = faces.size();
  std::vector<Surfaces> surfaces; // of each face one
  std::vector<double> gaps;
  for (const TopoDS_Face& face : faces) {
    surfaces.push_back({projector(BRep_Tool::Surface(face))});
    gaps.push_back(distance_of_edges(face, surfaces.back()));
    result.gap = (std::max)(result.gap, gaps.back());
  }
  if (faces.size() != solid.label_of_face.size())
    return result;
  BRepMesh_IncrementalMesh(shape, deflection * size_of(solid.mesh), false, angle);
  std::vector<std::vector<Mesh::Face_index>> triangles(solid.number_of_labels);
  for (auto f : solid.mesh.faces())
    triangles[solid.labels[f]].push_back(f);
  const Tree tree(solid.mesh.faces_begin(), solid.mesh.faces_end(), solid.mesh);
  result.faces.resize(triangles.size());
  Surfaces surface_of_label(triangles.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
    surface_of_label[solid.label_of_face[i]] = surfaces[i].front();
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const std::size_t label = solid.label_of_face[i];
    result.faces[label] = Comparison(solid, triangles[label], faces[i], surfaces[i],
                                     surface_of_label, tree)
                            .run();
    result.faces[label].of_edges = gaps[i];
  }
  return result;
}

} // namespace mesh_to_step
