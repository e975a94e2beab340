// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeform_surface.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/linear_least_squares_fitting_2.h>

#include <BSplCLib.hxx>
#include <Eigen/SparseCholesky>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_Pnt2d.hxx>
#include <math_Matrix.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

namespace mesh_to_step {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
namespace SMP = CGAL::Surface_mesh_parameterization;

constexpr int degree = 3;
/// Weights of samples: of edges, inside the face, and on triangles, which decide between the
/// others.
constexpr double of_border = 30, of_vertex = 1, of_triangles = 0.1;

/// A point that the surface goes through, and its parameters.
struct Sample
{
  gp_Pnt point;
  Surface_point foot;
  double weight;
};

using Parameters = Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2>;

/// Whether a map to the plane turns no triangle over.
bool is_flat(const Mesh& mesh, const Parameters& uv)
{
  return std::all_of(mesh.faces_begin(), mesh.faces_end(), [&](Mesh::Face_index f) {
    const auto h = halfedge(f, mesh);
    return CGAL::area(uv[source(h, mesh)], uv[target(h, mesh)], uv[target(next(h, mesh), mesh)]) >
           0;
  });
}

/// Whether a map to the plane is found: as rigid as possible, so that corners keep their size,
/// where all borders but the longest are filled meanwhile; else conformal.
bool flatten(Mesh& mesh, const Parameters& uv)
{
  const auto [outer, length] = PMP::longest_border(mesh);
  std::vector<Mesh::Halfedge_index> borders;
  std::vector<Mesh::Face_index> filling;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(borders));
  if (borders.empty())
    return false;
  for (const auto border : borders)
    if (PMP::face_border_length(border, mesh) < length)
      PMP::triangulate_hole(mesh, border, std::back_inserter(filling));
  const auto rigid = SMP::parameterize(mesh, SMP::ARAP_parameterizer_3<Mesh>(), outer, uv);
  for (const auto f : filling)
    CGAL::Euler::remove_face(halfedge(f, mesh), mesh);
  return (rigid == SMP::OK && is_flat(mesh, uv)) ||
         (SMP::parameterize(mesh, SMP::LSCM_parameterizer_3<Mesh>(), outer, uv) == SMP::OK &&
          is_flat(mesh, uv));
}

/// One of the two directions of a surface.
class Knots
{
public:
  Knots(double least, double greatest, int spans)
    : m_least(least)
    , m_greatest(greatest)
    , m_spans(spans)
    , m_flat(1, spans + 1 + 2 * degree)
  {
    for (int i = 1; i <= m_flat.Length(); ++i)
      m_flat(i) = knot((std::max)(0, (std::min)(spans, i - 1 - degree)));
  }

  int number_of_controls() const { return m_spans + degree; }
  double clamp(double t) const { return (std::max)(m_least, (std::min)(m_greatest, t)); }

  /// The values of the four B-splines that are not 0 at a parameter; returns the first of these.
  int values(double t, std::array<double, degree + 1>& result) const
  {
    int first = 0;
    math_Matrix basis(1, 1, 1, degree + 1);
    BSplCLib::EvalBsplineBasis(0, degree + 1, m_flat, clamp(t), first, basis);
    for (int i = 0; i <= degree; ++i)
      result[std::size_t(i)] = basis(1, i + 1);
    return first - 1;
  }

  TColStd_Array1OfReal knots() const
  {
    TColStd_Array1OfReal result(1, m_spans + 1);
    for (int i = 0; i <= m_spans; ++i)
      result(i + 1) = knot(i);
    return result;
  }
  TColStd_Array1OfInteger multiplicities() const
  {
    TColStd_Array1OfInteger result(1, m_spans + 1);
    result.Init(1);
    result(1) = result(m_spans + 1) = degree + 1;
    return result;
  }

private:
  double knot(int i) const { return m_least + (m_greatest - m_least) * i / m_spans; }

  double m_least, m_greatest;
  int m_spans;
  TColStd_Array1OfReal m_flat;
};

/// The surface of control points, a row each.
Handle(Geom_BSplineSurface)
  surface_of(const Eigen::MatrixX3d& controls, const Knots& u, const Knots& v)
{
  const int columns = v.number_of_controls();
  TColgp_Array2OfPnt poles(1, u.number_of_controls(), 1, columns);
  for (int i = 0; i < u.number_of_controls(); ++i)
    for (int j = 0; j < columns; ++j) {
      const Eigen::Vector3d p = controls.row(i * columns + j);
      poles(i + 1, j + 1) = gp_Pnt(p.x(), p.y(), p.z());
    }
  return new Geom_BSplineSurface(poles, u.knots(), v.knots(), u.multiplicities(),
                                 v.multiplicities(), degree, degree);
}

Eigen::Vector3d vector(const gp_Pnt& p)
{
  return {p.X(), p.Y(), p.Z()};
}

/// The surface of least squares, with a small weight on second differences of control points, which
/// decides beyond the face.
Handle(Geom_BSplineSurface) fit(const std::vector<Sample>& samples, const Knots& u, const Knots& v)
{
  constexpr double smoothness = 1e-3;
  const int columns = v.number_of_controls(), controls = u.number_of_controls() * columns;
  const Eigen::Vector3d origin = vector(samples.front().point); // rounding is relative to it
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<Eigen::Vector3d> right;
  for (const Sample& s : samples) {
    std::array<double, degree + 1> by_u, by_v;
    const int first_u = u.values(s.foot.parameters.X(), by_u),
              first_v = v.values(s.foot.parameters.Y(), by_v);
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; j <= degree; ++j)
        entries.emplace_back(int(right.size()), (first_u + i) * columns + first_v + j,
                             s.weight * by_u[std::size_t(i)] * by_v[std::size_t(j)]);
    right.push_back(s.weight * (vector(s.point) - origin));
  }
  for (int i = 0; i < u.number_of_controls(); ++i)
    for (int j = 0; j < columns; ++j)
      for (const int step : {columns, 1})
        if (step == 1 ? j > 0 && j + 1 < columns : i > 0 && i + 1 < u.number_of_controls()) {
          for (const int k : {-1, 0, 1})
            entries.emplace_back(int(right.size()), i * columns + j + k * step,
                                 smoothness * (k == 0 ? 2 : -1));
          right.push_back(Eigen::Vector3d::Zero());
        }
  Eigen::SparseMatrix<double> matrix(Eigen::Index(right.size()), controls);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::MatrixX3d sides(right.size(), 3);
  for (std::size_t i = 0; i < right.size(); ++i)
    sides.row(Eigen::Index(i)) = right[i];
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix.transpose() * matrix);
  if (solver.info() != Eigen::Success)
    return nullptr;
  const Eigen::MatrixX3d solution = solver.solve(matrix.transpose() * sides);
  return surface_of(solution.rowwise() + origin.transpose(), u, v);
}

/// Moves the foot of each sample to the point of the surface next to it, and returns the largest
/// distances: of vertices inside the face, and of the border.
std::array<double, 2> move_feet(std::vector<Sample>& samples, const Geom_Surface& surface)
{
  std::array<double, 2> farthest{};
  for (Sample& s : samples)
    if (s.weight >= of_vertex) {
      s.foot = descend(surface, s.foot, s.point);
      double& distance = farthest[s.weight == of_border];
      distance = (std::max)(distance, s.point.Distance(s.foot.point));
    }
  return farthest;
}

/// Turns parameters so that the first one runs along the longer side of the face, and scales them
/// to the lengths of the face.
void align(const Mesh& mesh, const Parameters& uv)
{
  std::vector<Kernel::Point_2> points;
  for (auto v : vertices(mesh))
    points.push_back(uv[v]);
  Kernel::Line_2 line;
  CGAL::linear_least_squares_fitting_2(points.begin(), points.end(), line,
                                       CGAL::Dimension_tag<0>());
  double flat = 0, length = 0;
  for (auto e : edges(mesh)) {
    flat += CGAL::squared_distance(uv[source(e, mesh)], uv[target(e, mesh)]);
    length += CGAL::squared_distance(mesh.point(source(e, mesh)), mesh.point(target(e, mesh)));
  }
  Kernel::Vector_2 along = line.to_vector();
  along *= std::sqrt(length / flat / along.squared_length());
  const Kernel::Vector_2 across = along.perpendicular(CGAL::COUNTERCLOCKWISE);
  for (auto v : vertices(mesh)) {
    const Kernel::Vector_2 p = uv[v] - CGAL::ORIGIN;
    uv[v] = {along * p, across * p};
  }
}

std::vector<Sample> samples_of(const Mesh& mesh, const Parameters& uv)
{
  constexpr int divisions = 8; // of a side of a triangle
  std::vector<Sample> result;
  const auto add = [&](const Point& point, const Kernel::Point_2& p, double weight) {
    result.push_back({point_of(point), {point_of(point), {p.x(), p.y()}}, weight});
  };
  for (auto v : vertices(mesh))
    add(mesh.point(v), uv[v], is_border(v, mesh) ? of_border : of_vertex);
  for (auto e : edges(mesh))
    for (int i = 1; !is_border(e, mesh) && i < divisions; ++i) {
      const auto a = source(e, mesh), b = target(e, mesh);
      const double share = double(i) / divisions;
      add(mesh.point(a) + share * (mesh.point(b) - mesh.point(a)), uv[a] + share * (uv[b] - uv[a]),
          of_triangles);
    }
  return result;
}

} // namespace

Handle(ShapeAnalysis_Surface) freeform_surface(Mesh mesh, double tolerance)
{
  constexpr double margin = 0.02, edge_share = 0.05;
  constexpr int most_pieces = 16384, rounds = 3;
  const Parameters uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  if (!flatten(mesh, uv))
    return nullptr;
  align(mesh, uv);
  const std::vector<Sample> samples = samples_of(mesh, uv);
  CGAL::Bbox_2 box;
  for (const Sample& s : samples)
    box += Kernel::Point_2(s.foot.parameters.X(), s.foot.parameters.Y()).bbox();
  const double width = box.xmax() - box.xmin(), height = box.ymax() - box.ymin(),
               border = margin * width;
  for (int spans = 16;; spans *= 2) {
    const int across = (std::max)(2, int(std::ceil(spans * height / width)));
    if (spans * across > most_pieces)
      return nullptr;
    const Knots u(box.xmin() - border, box.xmax() + border, spans),
      v(box.ymin() - border, box.ymax() + border, across);
    std::vector<Sample> moved = samples;
    for (int round = 0; round < rounds; ++round) {
      const Handle(Geom_BSplineSurface) surface = fit(moved, u, v);
      if (surface.IsNull())
        break;
      const auto [of_vertices, of_edges] = move_feet(moved, *surface);
      if (of_vertices <= tolerance && of_edges <= edge_share * tolerance) {
        std::vector<Surface_point> feet;
        for (const Sample& s : moved)
          if (s.weight >= of_vertex)
            feet.push_back(s.foot);
        return projector(surface, std::move(feet));
      }
    }
  }
}

} // namespace mesh_to_step
