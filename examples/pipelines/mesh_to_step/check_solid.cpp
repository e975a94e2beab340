// SPDX-License-Identifier: GPL-3.0-or-later

#include "check_solid.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/iterator.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepLib_CheckCurveOnSurface.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Poly_Triangulation.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

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

/// The largest distance from points of the edges of a face to its surface: to those that they have
/// on it, or to feet. Both may be too large where a surface is freeform.
double distance_of_edges(const TopoDS_Face& face, const Surfaces& surface)
{
  double result = 0;
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
    Curve_piece piece;
    piece.curve = BRep_Tool::Curve(edge, piece.first, piece.last);
    if (piece.curve.IsNull())
      continue; // a pole
    const auto spline = Handle(Geom_BSplineCurve)::DownCast(piece.curve);
    const int samples = spline.IsNull() ? 12 : 3 * spline->NbKnots();
    BRepLib_CheckCurveOnSurface check(edge, face);
    check.Perform();
    result = (std::max)(result, (std::min)(check.MaxDistance(), gap(piece, surface, samples)));
  }
  return result;
}

/// The vertices of the triangulation of a face; none if OpenCASCADE cannot triangulate it.
std::vector<Surface_point> points_of(const TopoDS_Face& face)
{
  std::vector<Surface_point> result;
  TopLoc_Location place;
  const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(face, place);
  for (int i = 1; !triangulation.IsNull() && i <= triangulation->NbNodes(); ++i)
    result.push_back({triangulation->Node(i).Transformed(place), triangulation->UVNode(i)});
  return result;
}

/// Includes all errors of a face but those of edges.
///
/// \param triangles what it is compared with
/// \param points of the face
void include_errors(Face_errors& result, const Solid& solid,
                    const std::vector<Mesh::Face_index>& triangles,
                    const std::vector<Surface_point>& points, const Surfaces& surface,
                    const Surfaces& surface_of_label, const Tree& tree)
{
  const Mesh& mesh = solid.mesh;
  const auto include = [](double& farthest, const Point& p, const Surfaces& surfaces) {
    farthest = (std::max)(farthest, distance(surfaces, point_of(p)));
  };
  for (auto f : triangles) {
    Kernel::Vector_3 sum = CGAL::NULL_VECTOR;
    for (auto h : halfedges_around_face(halfedge(f, mesh), mesh)) {
      const Point &a = mesh.point(source(h, mesh)), &b = mesh.point(target(h, mesh));
      Surfaces beside = surface;
      if (const auto& other = surface_of_label[solid.labels[face(opposite(h, mesh), mesh)]];
          !other.IsNull())
        beside.push_back(other);
      sum += a - CGAL::ORIGIN;
      include(result.of_vertices, a, surface);
      include(result.of_sides, CGAL::midpoint(a, b), beside);
    }
    include(result.of_sides, CGAL::ORIGIN + sum / 3, surface);
  }
  double farthest = points.empty() ? Precision::Infinite() : 0;
  for (const auto& [p, parameters] : points)
    farthest = (std::max)(farthest, tree.squared_distance({p.X(), p.Y(), p.Z()}));
  result.of_surface = (std::max)(result.of_surface, std::sqrt(farthest));
}

/// The labels of the faces that were read, in their order; none if they are not those of `solid`.
std::vector<std::size_t> labels_of(const Named_shape& read, const Solid& solid,
                                   const std::vector<std::string>& names)
{
  std::map<std::string, std::size_t> label_of;
  for (std::size_t i = 0; i < names.size(); ++i)
    label_of.emplace(names[i], solid.label_of_face[i]);
  std::vector<std::size_t> result;
  using Names = std::multiset<std::string>; // seams may divide a face
  if (Names(names.begin(), names.end()) == Names(read.face_names.begin(), read.face_names.end()))
    for (const std::string& name : read.face_names)
      result.push_back(label_of[name]);
  return result;
}

/// Measures the bodies of a shape.
Certificate measure(const Named_shape& read)
{
  constexpr double precision = 1e-5; // of area and volume
  Certificate result;
  auto name = read.face_names.begin();
  for (TopExp_Explorer solid(read.shape, TopAbs_SOLID); solid.More(); solid.Next()) {
    GProp_GProps volume, area;
    BRepGProp::VolumeProperties(solid.Current(), volume, precision);
    BRepGProp::SurfaceProperties(solid.Current(), area, precision);
    const auto first = name;
    name += std::ptrdiff_t(faces_of(solid.Current()).size());
    result.bodies.push_back({volume.Mass(), area.Mass(), {first, name}});
    result.volume += volume.Mass();
    result.area += area.Mass();
  }
  result.is_closed = !result.bodies.empty() && has_closed_shells(read.shape);
  result.is_valid = !read.shape.IsNull() && BRepCheck_Analyzer(read.shape).IsValid();
  return result;
}

} // namespace

Certificate compare(const Named_shape& read, const Solid& solid,
                    const std::vector<std::string>& names)
{
  constexpr double deflection = 1e-3, angle = 0.3;
  Certificate result = measure(read);
  if (read.shape.IsNull())
    return result;
  BRepMesh_IncrementalMesh(read.shape, deflection * size_of(solid.mesh), false, angle);
  const std::vector<std::size_t> labels = labels_of(read, solid, names);
  const std::vector<TopoDS_Face> faces = faces_of(read.shape);
  result.number_of_faces = faces.size();
  std::vector<std::vector<Surface_point>> points;
  std::vector<Surfaces> surfaces; // of each face one
  std::vector<double> gaps;
  for (const TopoDS_Face& face : faces) {
    points.push_back(points_of(face));
    surfaces.push_back({projector(BRep_Tool::Surface(face), points.back())});
    gaps.push_back(distance_of_edges(face, surfaces.back()));
    result.gap = (std::max)(result.gap, gaps.back());
  }
  if (labels.empty())
    return result;
  std::vector<std::vector<Mesh::Face_index>> triangles(solid.number_of_labels);
  for (auto f : solid.mesh.faces())
    triangles[solid.labels[f]].push_back(f);
  const Tree tree(solid.mesh.faces_begin(), solid.mesh.faces_end(), solid.mesh);
  result.faces.resize(triangles.size());
  Surfaces surface_of_label(triangles.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
    surface_of_label[labels[i]] = surfaces[i].front();
  for (std::size_t i = 0; i < faces.size(); ++i) {
    Face_errors& errors = result.faces[labels[i]];
    include_errors(errors, solid, triangles[labels[i]], points[i], surfaces[i], surface_of_label,
                   tree);
    errors.of_edges = (std::max)(errors.of_edges, gaps[i]);
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Face_errors& e = result.faces[i];
    result.volume_error += CGAL::Polygon_mesh_processing::area(triangles[i], solid.mesh) *
                           (std::max)({e.of_vertices, e.of_surface, e.of_sides});
  }
  return result;
}

} // namespace mesh_to_step
