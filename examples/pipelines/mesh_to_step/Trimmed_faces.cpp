// SPDX-License-Identifier: GPL-3.0-or-later

#include "Trimmed_faces.h"

#include "freeform_surface.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Region_segmentation/Segments/segment_borders.h>
#include <CGAL/boost/graph/iterator.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepGProp.hxx>
#include <BRepLib.hxx>
#include <BRepLib_CheckCurveOnSurface.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <ShapeFix_Edge.hxx>
#include <ShapeFix_Face.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace mesh_to_step {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

constexpr double precision = 1e-7; // of a point or an edge, until the distance to its faces is
                                   // known

} // namespace

double size_of(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  return point_of({box.xmin(), box.ymin(), box.zmin()})
    .Distance(point_of({box.xmax(), box.ymax(), box.zmax()}));
}

Trimmed_faces::Trimmed_faces(const Mesh& mesh, const Labelled_faces& labelled_faces)
  : m_mesh(mesh)
  , m_faces(labelled_faces)
  , m_size(size_of(mesh))
  , m_triangles(m_faces.surfaces.size())
  , m_border_halfedges(m_faces.surfaces.size())
  , m_surfaces(m_faces.surfaces.size())
  , m_shapes(m_faces.surfaces.size())
{
  for (auto f : faces(mesh)) {
    m_triangles[m_faces.labels[f]].push_back(f);
    for (Halfedge h : halfedges_around_face(halfedge(f, mesh), mesh))
      if (label(h) != label(opposite(h, mesh)))
        m_border_halfedges[label(h)].push_back(h);
  }
  for (std::size_t face = 0; face < m_shapes.size(); ++face)
    if (!is_freeform(face))
      m_surfaces[face] = projector(simple_surface(with_axis(face)));
  make_edges();
  for (std::size_t face = 0; face < m_shapes.size(); ++face) {
    if (is_freeform(face))
      make_freeform_surface(face);
    if (!m_surfaces[face].IsNull())
      m_shapes[face] = make_face(face);
  }
  for (TopoDS_Shape& shape : m_shapes)
    if (!shape.IsNull())
      shape = m_context->Apply(shape);
  set_tolerances();
}

bool Trimmed_faces::is_right(std::size_t face) const
{
  constexpr double most = 2; // triangles may be coarse
  const TopoDS_Shape& shape = m_shapes[face];
  if (shape.IsNull())
    return false;
  GProp_GProps measured;
  BRepGProp::SurfaceProperties(shape, measured);
  const double area = PMP::area(m_triangles[face], m_mesh);
  return measured.Mass() < most * area && area < most * measured.Mass();
}

/// The border of a face, as loops of halfedges of it.
std::vector<Trimmed_faces::Halfedges> Trimmed_faces::loops(std::size_t face) const
{
  std::vector<Halfedges> result;
  std::set<Halfedge> visited;
  for (Halfedge first : m_border_halfedges[face]) {
    Halfedges loop;
    for (Halfedge h = first; visited.insert(h).second; h = next_at_border(h))
      loop.push_back(h);
    if (!loop.empty())
      result.push_back(std::move(loop));
  }
  return result;
}

Trimmed_faces::Halfedge Trimmed_faces::next_at_border(Halfedge h) const
{
  const std::size_t face = label(h);
  h = next(h, m_mesh);
  while (label(opposite(h, m_mesh)) == face)
    h = next(opposite(h, m_mesh), m_mesh);
  return h;
}

/// Those of the faces that have one.
Surfaces Trimmed_faces::simple_surfaces(const std::set<std::size_t>& faces) const
{
  Surfaces result;
  for (const std::size_t face : faces)
    if (!is_freeform(face))
      result.push_back(m_surfaces[face]);
  return result;
}

/// The surface of a face. The axis of a sphere may be any: the first one, of the directions of
/// neighbors and of others, whose poles are not near the border of the face, and whose seam crosses
/// it at most once.
Fitted_surface Trimmed_faces::with_axis(std::size_t face) const
{
  constexpr int number_of_others = 100;
  Fitted_surface result = m_faces.surfaces[face];
  if (result.kind != RS::Surface_kind::SPHERE)
    return result;
  std::vector<Kernel::Vector_3> candidates;
  for (Halfedge h : m_border_halfedges[face])
    if (const std::size_t other = label(opposite(h, m_mesh)); !is_freeform(other))
      candidates.push_back(m_faces.surfaces[other].direction);
  for (int i = 0; i < number_of_others; ++i) { // on a spiral from pole to pole
    const double z = (i + 0.5) / number_of_others, r = std::sqrt(1 - z * z), angle = 2.4 * i;
    candidates.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  const auto found = std::find_if(candidates.begin(), candidates.end(), [&](const auto& axis) {
    return can_be_axis(gp_Dir(axis.x(), axis.y(), axis.z()), face);
  });
  if (found != candidates.end())
    result.direction = *found;
  return result;
}

bool Trimmed_faces::can_be_axis(const gp_Dir& axis, std::size_t face) const
{
  constexpr double farthest = 0.98; // of a point of the border along the axis, of the radius
  const gp_Vec seam(seam_direction(axis)), beside = gp_Vec(axis) ^ seam;
  const Fitted_surface& s = m_faces.surfaces[face];
  int crossings = 0;
  for (Halfedge h : m_border_halfedges[face]) {
    const gp_Vec from(point_of(s.point), source_point(h)),
      to(point_of(s.point), source_point(next(h, m_mesh)));
    if (std::fabs(from.Dot(axis)) > farthest * s.radius)
      return false;
    if ((from + to).Dot(seam) > 0 && (from.Dot(beside) < 0) != (to.Dot(beside) < 0))
      ++crossings;
  }
  return crossings <= 1;
}

/// A surface through the vertices of a freeform face, and points of its edges.
void Trimmed_faces::make_freeform_surface(std::size_t face)
{
  constexpr double tolerance = 1e-4; // of the size
  constexpr std::size_t most_edge_points = 4000;
  const int divisions = int(
    std::clamp<std::size_t>(most_edge_points / (m_border_halfedges[face].size() + 1), 4, 16));
  Mesh triangles;
  std::map<Mesh::Vertex_index, Mesh::Vertex_index> copies;
  for (auto f : m_triangles[face]) {
    std::vector<Mesh::Vertex_index> corners;
    for (Halfedge h : halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
      const auto [copy, is_new] = copies.emplace(source(h, m_mesh), Mesh::Vertex_index());
      if (is_new)
        copy->second = triangles.add_vertex(m_mesh.point(source(h, m_mesh)));
      corners.push_back(copy->second);
      if (const auto piece = m_pieces.find(h); piece != m_pieces.end())
        for (int i = 0; i < divisions; ++i) {
          const gp_Pnt p = piece->second.point(double(i) / divisions);
          if (i > 0)
            corners.push_back(triangles.add_vertex());
          triangles.point(corners.back()) = {p.X(), p.Y(), p.Z()};
        }
    }
    std::vector<Point> points;
    for (auto v : corners)
      points.push_back(triangles.point(v));
    std::vector<CGAL::Triple<int, int, int>> patch;
    PMP::triangulate_hole_polyline(points, std::back_inserter(patch));
    for (const auto& t : patch)
      if (triangles.add_face(corners[std::size_t(t.first)], corners[std::size_t(t.second)],
                             corners[std::size_t(t.third)]) == Mesh::null_face())
        return; // the face touches itself at a vertex
  }
  m_surfaces[face] = freeform_surface(triangles, tolerance * m_size);
}

/// The vertex of the solid for one of the mesh, on all simple surfaces there.
TopoDS_Vertex Trimmed_faces::vertex(Mesh::Vertex_index v)
{
  TopoDS_Vertex& result = m_vertices[v];
  if (result.IsNull()) {
    std::set<std::size_t> around;
    for (Halfedge h : halfedges_around_target(v, m_mesh))
      around.insert(label(h));
    const gp_Pnt p = nearest_point(simple_surfaces(around), point_of(m_mesh.point(v)));
    m_builder.MakeVertex(result, p, precision);
  }
  return result;
}

void Trimmed_faces::make_edges()
{
  std::vector<RS::Segment_border<Mesh, std::size_t>> borders;
  RS::extract_segment_borders(m_mesh, m_faces.labels, std::back_inserter(borders));
  for (const auto& border : borders) {
    const Halfedges& chain = border.halfedges;
    if (border.is_closed || source(chain.front(), m_mesh) != target(chain.back(), m_mesh))
      make_edge(chain, border.is_closed);
    else { // from a junction to itself
      const auto middle = chain.begin() + std::ptrdiff_t(chain.size() / 2);
      make_edge({chain.begin(), middle}, false);
      make_edge({middle, chain.end()}, false);
    }
  }
}

/// The surfaces to both sides of a border that its curve is on.
Surfaces Trimmed_faces::surfaces_along(Halfedge h) const
{
  const std::set<std::size_t> sides{label(h), label(opposite(h, m_mesh))};
  for (const std::size_t face : sides)
    // A facet that is nearly tangent to its neighbor meets its surface elsewhere.
    if (m_faces.is_facet[face])
      return {};
  return simple_surfaces(sides);
}

/// How far the points of a border may be from its curve.
double Trimmed_faces::tolerance_along(Halfedge h) const
{
  double result = 1e-6 * m_size;
  for (const std::size_t face : {label(h), label(opposite(h, m_mesh))})
    result = (std::max)(result, 2 * m_faces.surfaces[face].deviation);
  return result;
}

void Trimmed_faces::make_edge(const Halfedges& chain, bool is_closed)
{
  const Surfaces surfaces = surfaces_along(chain.front());
  Border border{{}, is_closed};
  for (Halfedge h : chain)
    border.points.push_back(nearest_point(surfaces, source_point(h)));
  border.points.push_back(border.points.front());
  TopoDS_Vertex first, last;
  if (!is_closed) {
    first = vertex(source(chain.front(), m_mesh));
    last = vertex(target(chain.back(), m_mesh));
    border.points.front() = BRep_Tool::Pnt(first);
    border.points.back() = BRep_Tool::Pnt(last);
  }
  const Border_curve curve = make_curve(border, surfaces, tolerance_along(chain.front()));
  if (is_closed) {
    m_builder.MakeVertex(first, curve.piece.curve->Value(curve.piece.first), precision);
    last = first;
  }
  TopoDS_Edge edge;
  m_builder.MakeEdge(edge, curve.piece.curve, precision);
  m_builder.Add(edge, first.Oriented(TopAbs_FORWARD));
  m_builder.Add(edge, last.Oriented(TopAbs_REVERSED));
  m_builder.Range(edge, curve.piece.first, curve.piece.last);
  ShapeFix_Edge().FixVertexTolerance(edge);
  m_edges[chain.front()] = edge;
  m_edges[opposite(chain.back(), m_mesh)] = TopoDS::Edge(edge.Reversed());
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const double from = curve.parameters[i], to = curve.parameters[i + 1];
    m_pieces[chain[i]] = {curve.piece.curve, from, to};
    m_pieces[opposite(chain[i], m_mesh)] = {curve.piece.curve, to, from};
  }
}

/// Gives an edge its curve in the parameters of a freeform surface. (That of OpenCASCADE misses
/// nearest points.)
void Trimmed_faces::add_parameter_curve(const TopoDS_Edge& edge, std::size_t face)
{
  double first = 0, last = 0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve);
  const int n = spline.IsNull() ? 24 : 3 * spline->NbKnots();
  const Handle(TColgp_HArray1OfPnt2d) points = new TColgp_HArray1OfPnt2d(1, n + 1);
  const Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, n + 1);
  for (int i = 0; i <= n; ++i) {
    const double t = first + (last - first) * i / n;
    parameters->SetValue(i + 1, t);
    points->SetValue(i + 1, parameters_of_foot(m_surfaces[face], curve->Value(t)));
  }
  Geom2dAPI_Interpolate interpolate(points, parameters, false, 1e-12);
  interpolate.Perform();
  m_builder.UpdateEdge(edge, interpolate.Curve(), m_surfaces[face]->Surface(), TopLoc_Location(),
                       precision);
}

TopoDS_Shape Trimmed_faces::make_face(std::size_t face)
try {
  const Handle(Geom_Surface) surface = m_surfaces[face]->Surface();
  const bool is_reversed = m_faces.surfaces[face].side < 0;
  TopoDS_Face trimmed;
  m_builder.MakeFace(trimmed, surface, precision);
  for (const Halfedges& loop : loops(face)) {
    TopoDS_Wire wire;
    m_builder.MakeWire(wire);
    for (Halfedge h : loop)
      if (const auto edge = m_edges.find(h); edge != m_edges.end()) {
        if (is_freeform(face))
          add_parameter_curve(edge->second, face);
        m_builder.Add(wire, is_reversed ? edge->second.Reversed() : edge->second);
      }
    wire.Closed(true);
    m_builder.Add(trimmed, wire);
  }
  if (m_border_halfedges[face].empty()) // a whole sphere or torus
    trimmed = BRepBuilderAPI_MakeFace(surface, precision);
  ShapeFix_Face fix(trimmed); // adds curves in parameters, seams and poles
  fix.SetContext(m_context);
  fix.FixOrientationMode() = 0;
  fix.FixPeriodicDegeneratedMode() = 1;
  fix.Perform();
  return is_reversed ? fix.Result().Reversed() : fix.Result();
} catch (const Standard_Failure&) {
  return {};
}

/// Makes the tolerances of edges as large as their distances to their faces, and those of vertices
/// not smaller.
void Trimmed_faces::set_tolerances()
{
  constexpr double margin = 1.1; // OpenCASCADE measures at other points
  for (TopoDS_Shape& shape : m_shapes)
    try {
      if (!shape.IsNull())
        BRepLib::SameParameter(shape, precision, true);
    } catch (const Standard_Failure&) {
      shape.Nullify();
    }
  for (const TopoDS_Shape& shape : m_shapes)
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
      for (TopExp_Explorer edges(faces.Current(), TopAbs_EDGE); edges.More(); edges.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
        BRepLib_CheckCurveOnSurface check(edge, TopoDS::Face(faces.Current()));
        check.Perform();
        if (check.IsDone() && check.MaxDistance() > BRep_Tool::Tolerance(edge))
          m_builder.UpdateEdge(edge, margin * check.MaxDistance());
      }
  for (const TopoDS_Shape& shape : m_shapes)
    if (!shape.IsNull())
      BRepLib::UpdateTolerances(shape);
}

} // namespace mesh_to_step
