// SPDX-License-Identifier: GPL-3.0-or-later

#include "freeform_surface.h"

#include "part_surface.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <BSplCLib.hxx>
#include <Eigen/Eigenvalues>
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

namespace mesh_to_step {

namespace {

namespace SMP = CGAL::Surface_mesh_parameterization;

constexpr int degree = 3;

/// A point that the surface goes through, and its parameters.
struct Sample
{
  gp_Pnt point;
  double u, v;
  bool is_of_edge;
};

using Parameters = Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2>;

/// Whether a conformal map to the plane is found that turns no triangle over.
bool flatten(Mesh& mesh, const Parameters& uv)
{
  const auto border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  using Parameterizer = SMP::LSCM_parameterizer_3<Mesh>;
  if (border == Mesh::null_halfedge() ||
      SMP::parameterize(mesh, Parameterizer(), border, uv) != SMP::OK)
    return false;
  std::array<bool, 2> found{};
  for (auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    found[CGAL::area(uv[source(h, mesh)], uv[target(h, mesh)], uv[target(next(h, mesh), mesh)]) >
          0] = true;
  }
  return !(found[0] && found[1]);
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

/// The surface of least squares, with a small weight on second differences of control points, which
/// decides where there are no samples.
Handle(Geom_BSplineSurface) fit(const std::vector<Sample>& samples, const Knots& u, const Knots& v)
{
  constexpr double edge_weight = 30, smoothness = 1e-3;
  const int columns = v.number_of_controls(), controls = u.number_of_controls() * columns;
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<Eigen::Vector3d> right;
  for (const Sample& s : samples) {
    std::array<double, degree + 1> by_u, by_v;
    const int first_u = u.values(s.u, by_u), first_v = v.values(s.v, by_v);
    const double weight = s.is_of_edge ? edge_weight : 1;
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; j <= degree; ++j)
        entries.emplace_back(int(right.size()), (first_u + i) * columns + first_v + j,
                             weight * by_u[std::size_t(i)] * by_v[std::size_t(j)]);
    right.push_back(weight * Eigen::Vector3d(s.point.X(), s.point.Y(), s.point.Z()));
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
  return surface_of(solution, u, v);
}

/// Moves the parameters of each sample to those of the point of the surface next to it, and returns
/// the largest distances: of other samples, and of those of edges.
std::array<double, 2> move_to_feet(std::vector<Sample>& samples, const Geom_BSplineSurface& surface,
                                   const Knots& u, const Knots& v)
{
  constexpr int steps = 3;
  std::array<double, 2> farthest{};
  for (Sample& s : samples)
    for (int step = 0; step <= steps; ++step) {
      gp_Pnt p;
      gp_Vec by_u, by_v;
      surface.D1(s.u, s.v, p, by_u, by_v);
      const gp_Vec d(p, s.point);
      if (step == steps) {
        farthest[s.is_of_edge] = (std::max)(farthest[s.is_of_edge], d.Magnitude());
        break;
      }
      if (const auto move = step_to_foot(by_u, by_v, d)) {
        s.u = u.clamp(s.u + move->X());
        s.v = v.clamp(s.v + move->Y());
      }
    }
  return farthest;
}

/// Turns parameters so that the first one runs along the longer side of the face, and scales them
/// to the lengths of the face.
void align(Mesh& mesh, const Parameters& uv)
{
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (auto v : vertices(mesh))
    mean += Eigen::Vector2d(uv[v].x(), uv[v].y()) / double(num_vertices(mesh));
  Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
  double flat = 0, length = 0;
  for (auto v : vertices(mesh)) {
    const Eigen::Vector2d d = Eigen::Vector2d(uv[v].x(), uv[v].y()) - mean;
    moments += d * d.transpose();
  }
  for (auto e : edges(mesh)) {
    const auto a = source(e, mesh), b = target(e, mesh);
    flat += CGAL::squared_distance(uv[a], uv[b]);
    length += CGAL::squared_distance(mesh.point(a), mesh.point(b));
  }
  const Eigen::Matrix2d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(moments)
                                 .eigenvectors();
  const double scale = std::sqrt(length / flat);
  for (auto v : vertices(mesh)) {
    const Eigen::Vector2d d = scale * (Eigen::Vector2d(uv[v].x(), uv[v].y()) - mean);
    uv[v] = {axes.col(1).dot(d), axes.col(0).dot(d)};
  }
}

std::vector<Sample> samples_of(Mesh& mesh, const Parameters& uv,
                               const std::vector<Edge_point>& edges)
{
  std::vector<Sample> result;
  for (auto v : vertices(mesh)) {
    const Point& p = mesh.point(v);
    if (!is_border(v, mesh))
      result.push_back({{p.x(), p.y(), p.z()}, uv[v].x(), uv[v].y(), false});
  }
  for (const Edge_point& e : edges) {
    const auto p = uv[e.from] + e.share * (uv[e.to] - uv[e.from]);
    result.push_back({e.point, p.x(), p.y(), true});
  }
  return result;
}

} // namespace

Handle(Geom_Surface)
  freeform_surface(const Mesh& triangles, const std::vector<Edge_point>& edges, double tolerance)
{
  constexpr double margin = 0.02, edge_share = 0.05;
  constexpr int most_spans = 64, rounds = 4;
  Mesh mesh = triangles;
  const Parameters uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  if (!flatten(mesh, uv))
    return nullptr;
  align(mesh, uv);
  const std::vector<Sample> samples = samples_of(mesh, uv, edges);
  CGAL::Bbox_2 box;
  for (const Sample& s : samples)
    box += CGAL::Bbox_2(s.u, s.v, s.u, s.v);
  const double width = box.xmax() - box.xmin(), height = box.ymax() - box.ymin(),
               border = margin * width;
  for (int spans = 8; spans <= most_spans; spans *= 2) {
    const int across = (std::max)(4, int(std::ceil(spans * height / width)));
    const Knots u(box.xmin() - border, box.xmax() + border, spans),
      v(box.ymin() - border, box.ymax() + border, across);
    std::vector<Sample> moved = samples;
    for (int round = 0; round < rounds; ++round) {
      const Handle(Geom_BSplineSurface) surface = fit(moved, u, v);
      if (surface.IsNull())
        break;
      const auto [of_vertices, of_edges] = move_to_feet(moved, *surface, u, v);
      if (of_vertices <= tolerance && of_edges <= edge_share * tolerance)
        return Handle(Geom_Surface)(surface);
    }
  }
  return nullptr;
}

} // namespace mesh_to_step
