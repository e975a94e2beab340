// SPDX-License-Identifier: GPL-3.0-or-later

#include "design_intent.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/boost/graph/iterator.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace mesh_to_step {

namespace {

using Kind = RS::Surface_kind;
using Vector = Eigen::Vector3d;

constexpr int size_of_shape = 9;
/// Point, direction, radius, minor radius and angle of a surface, of which its kind may use some.
using Numbers = Eigen::Matrix<double, size_of_shape, 1>;

/// A surface of a part of size 1.
struct Shape
{
  Kind kind;
  Numbers x;

  Vector point() const { return x.head<3>(); }
  Vector direction() const { return x.segment<3>(3).normalized(); }
  bool has_direction() const { return kind != Kind::SPHERE && kind != Kind::FREEFORM; }
  bool has_axis() const { return has_direction() && kind != Kind::PLANE; }
  /// Whether the surface has one distance, its radius, from its spine: a point, line or circle.
  bool has_spine() const
  {
    return kind == Kind::CYLINDER || kind == Kind::SPHERE || kind == Kind::TORUS;
  }
  double radius() const { return x[kind == Kind::TORUS ? 7 : 6]; }
};

double signed_distance(const Shape& s, const Vector& p)
{
  const Vector d = p - s.point();
  const double z = d.dot(s.direction()), r = (d - z * s.direction()).norm();
  switch (s.kind) {
  case Kind::CYLINDER:
    return r - s.x[6];
  case Kind::CONE:
    return (r - s.x[6]) * std::cos(s.x[8]) - z * std::sin(s.x[8]);
  case Kind::SPHERE:
    return d.norm() - s.x[6];
  case Kind::TORUS:
    return std::hypot(r - s.x[6], z) - s.x[7];
  default:
    return z;
  }
}

/// The point of the spine next to `p`.
Vector spine_point(const Shape& s, const Vector& p)
{
  const Vector along = (p - s.point()).dot(s.direction()) * s.direction();
  if (s.kind == Kind::CYLINDER)
    return s.point() + along;
  if (s.kind == Kind::TORUS)
    return s.point() + s.x[6] * (p - s.point() - along).normalized();
  return s.point();
}

/// Moves the point of a cylinder or cone, which may be any of the axis, to the one next to `p`.
void move_back_along_axis(Shape& s, const Vector& p)
{
  const double z = (p - s.point()).dot(s.direction());
  if (s.kind == Kind::CYLINDER || s.kind == Kind::CONE)
    s.x.head<3>() += z * s.direction();
  if (s.kind == Kind::CONE)
    s.x[6] += z * std::tan(s.x[8]);
}

/// A function of two surfaces that is 0 where a relation of them holds.
using Residual = std::function<Eigen::VectorXd(const Shape&, const Shape&)>;

struct Relation
{
  Relation_of_faces name;
  Residual residual;
};

Eigen::VectorXd number(double x)
{
  return Eigen::VectorXd::Constant(1, x);
}

Eigen::VectorXd cross_of_directions(const Shape& s, const Shape& t)
{
  return s.direction().cross(t.direction());
}

Eigen::VectorXd dot_of_directions(const Shape& s, const Shape& t)
{
  return number(s.direction().dot(t.direction()));
}

/// The vector from the axis of the first surface to the point of the second one.
Eigen::VectorXd distance_of_axes(const Shape& s, const Shape& t)
{
  const Vector d = t.point() - s.point();
  return d - d.dot(s.direction()) * s.direction();
}

Eigen::VectorXd height(const Shape& s, const Shape& t)
{
  return number((t.point() - s.point()).dot(s.direction()));
}

Eigen::VectorXd difference_of_radii(const Shape& s, const Shape& t)
{
  return number(t.radius() - s.radius());
}

/// The vector between the spines where they should touch.
Eigen::VectorXd distance_of_spines(const Shape& s, const Shape& t)
{
  const Vector p = spine_point(s, t.point());
  return spine_point(t, p) - p;
}

/// The derivatives of a function of shapes, which returns a vector, by their numbers.
template <typename Function>
Eigen::MatrixXd derivatives(const Function& f, std::vector<Shape> shapes)
{
  constexpr double step = 1e-6;
  Eigen::MatrixXd result;
  for (std::size_t s = 0; s < shapes.size(); ++s)
    for (int i = 0; i < size_of_shape; ++i) {
      const double x = shapes[s].x[i];
      shapes[s].x[i] = x + step;
      const Eigen::VectorXd above = f(shapes);
      shapes[s].x[i] = x - step;
      const Eigen::VectorXd below = f(shapes);
      shapes[s].x[i] = x;
      if (result.size() == 0)
        result.resize(above.size(), Eigen::Index(shapes.size()) * size_of_shape);
      result.col(Eigen::Index(s) * size_of_shape + i) = (above - below) / (2 * step);
    }
  return result;
}

/// The derivatives of a residual: by the numbers of the first surface, and by those of the second.
Eigen::MatrixXd slopes_of(const Residual& residual, const Shape& first, const Shape& second)
{
  return derivatives([&](const std::vector<Shape>& s) { return residual(s[0], s[1]); },
                     {first, second});
}

/// The surfaces of a part, the points that they were fitted to, and their relations.
class Design
{
public:
  Design(const Mesh& mesh, const Labels& labels, const Part_faces& faces);

  const std::vector<Relation>& relations() const { return m_relations; }

  void find_relations();
  /// Moves the surfaces, so that relations hold.
  void solve();
  /// Drops the relations that do not hold, or else those of surfaces that have left their points;
  /// returns whether there are any. Surfaces are as before solving then.
  bool drop_wrong_relations();
  void write(Part_faces& faces) const;

private:
  using Matrix = Eigen::Matrix<double, size_of_shape, size_of_shape>;
  using Faces = std::vector<std::size_t>;

  Shape shape(const Fitted_surface& s) const;
  double deviation(std::size_t face) const;
  double error_of(const Relation& r) const;
  double error_of(std::size_t face) const;
  void linearize();
  double error_of_points() const;
  bool add(const std::string& name, std::size_t first, std::size_t second,
           const Residual& residual);
  bool add_to_one(const std::string& name, const Faces& firsts, std::size_t second,
                  const Residual& residual);
  void find_directions(const Faces& by_area);
  void find_tangent_faces();
  Eigen::VectorXd move() const;

  const Part_faces& m_faces;
  Vector m_center;
  double m_size;
  std::vector<Shape> m_shapes;
  std::vector<Shape> m_found; ///< the shapes before any was moved
  std::vector<std::vector<Vector>> m_points;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Vector>> m_border_points;
  std::vector<Matrix> m_squares; ///< of the derivatives of distances, damped
  std::vector<Numbers> m_slopes; ///< of the sum of squared distances
  double m_error = 0;            ///< of a point: the standard deviation
  std::vector<Faces> m_parallel; ///< the largest face of each group first
  std::vector<Relation> m_relations;
};

Design::Design(const Mesh& mesh, const Labels& labels, const Part_faces& faces)
  : m_faces(faces)
  , m_points(faces.size())
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const Vector low(box.xmin(), box.ymin(), box.zmin()), high(box.xmax(), box.ymax(), box.zmax());
  m_center = (low + high) / 2;
  m_size = (high - low).norm();
  for (const auto& face : faces)
    m_shapes.push_back(shape(face.surface));
  m_found = m_shapes;
  for (auto v : vertices(mesh)) {
    std::set<std::size_t> around;
    for (auto f : faces_around_target(halfedge(v, mesh), mesh))
      if (f != Mesh::null_face())
        around.insert(labels[f]);
    const Point& p = mesh.point(v);
    const Vector q = (Vector(p.x(), p.y(), p.z()) - m_center) / m_size;
    for (const std::size_t face : around) {
      m_points[face].push_back(q);
      for (const std::size_t other : around)
        m_border_points[{face, other}].push_back(q);
    }
  }
}

Shape Design::shape(const Fitted_surface& s) const
{
  Shape result{s.kind, Numbers::Zero()};
  result.x.head<3>() = (Vector(s.point.x(), s.point.y(), s.point.z()) - m_center) / m_size;
  result.x.segment<3>(3) << s.direction.x(), s.direction.y(), s.direction.z();
  result.x.tail<3>() << s.radius / m_size, s.minor_radius / m_size, s.angle;
  return result;
}

double Design::deviation(std::size_t face) const
{
  double result = 0;
  for (const Vector& p : m_points[face])
    result = (std::max)(result, std::fabs(signed_distance(m_shapes[face], p)));
  return result;
}

/// Writes the equations of least squares of each surface.
void Design::linearize()
{
  constexpr double damping = 1e-7;
  m_squares.assign(m_shapes.size(), damping * Matrix::Identity());
  m_slopes.assign(m_shapes.size(), Numbers::Zero());
  for (std::size_t i = 0; i < m_shapes.size(); ++i)
    if (m_shapes[i].kind != Kind::FREEFORM)
      for (const Vector& p : m_points[i]) {
        const auto distance = [&](const std::vector<Shape>& s) {
          return number(signed_distance(s[0], p));
        };
        const Numbers slope = derivatives(distance, {m_shapes[i]}).transpose();
        m_squares[i] += slope * slope.transpose();
        m_slopes[i] += distance({m_shapes[i]})[0] * slope;
      }
}

/// The standard deviation of a distance, of those of all points.
double Design::error_of_points() const
{
  constexpr double unknowns[] = {3, 5, 6, 4, 7}, rounding = 1e-8;
  double sum = 0, freedom = 1;
  for (std::size_t i = 0; i < m_shapes.size(); ++i)
    if (m_shapes[i].kind != Kind::FREEFORM) {
      freedom += (std::max)(0.0, double(m_points[i].size()) - unknowns[int(m_shapes[i].kind)]);
      for (const Vector& p : m_points[i])
        sum += std::pow(signed_distance(m_shapes[i], p), 2);
    }
  return (std::max)(rounding, std::sqrt(sum / freedom));
}

/// Adds a relation that holds within four standard errors.
bool Design::add(const std::string& name, std::size_t first, std::size_t second,
                 const Residual& residual)
{
  constexpr double errors = 4, rounding = 1e-8, most = 0.01;
  const Eigen::VectorXd r = residual(m_shapes[first], m_shapes[second]);
  if (r.cwiseAbs().maxCoeff() > most)
    return false;
  const Eigen::MatrixXd by_numbers = slopes_of(residual, m_shapes[first], m_shapes[second]);
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(r.size());
  for (const auto& [face, column] : {std::make_pair(first, 0), {second, size_of_shape}}) {
    const Eigen::MatrixXd slopes = by_numbers.middleCols(column, size_of_shape);
    variance += (slopes * m_squares[face].inverse() * slopes.transpose()).diagonal();
  }
  for (Eigen::Index i = 0; i < r.size(); ++i)
    if (std::fabs(r[i]) > rounding + errors * m_error * std::sqrt(variance[i]))
      return false;
  m_relations.push_back({{name, first, second}, residual});
  return true;
}

/// Adds the relation to the first face that has it; returns whether one has.
bool Design::add_to_one(const std::string& name, const Faces& firsts, std::size_t second,
                        const Residual& residual)
{
  return std::any_of(firsts.begin(), firsts.end(),
                     [&](std::size_t first) { return add(name, first, second, residual); });
}

void Design::find_directions(const Faces& by_area)
{
  for (const std::size_t face : by_area) {
    if (!m_shapes[face].has_direction())
      continue;
    const auto group = std::find_if(m_parallel.begin(), m_parallel.end(), [&](const Faces& faces) {
      return add("parallel", faces.front(), face, cross_of_directions);
    });
    if (group != m_parallel.end()) {
      group->push_back(face);
      continue;
    }
    for (const Faces& faces : m_parallel)
      add("perpendicular", faces.front(), face, dot_of_directions);
    m_parallel.push_back({face});
  }
}

/// Of two surfaces that are tangent, the spine of the second is as far from the first as its
/// radius; or, if their radii are equal, their spines touch.
void Design::find_tangent_faces()
{
  constexpr double coincident = 0.1; // of the radius
  for (std::size_t i = 0; i < m_shapes.size(); ++i)
    for (const auto& neighbor : m_faces[i].neighbors) {
      const std::size_t j = neighbor.face;
      const Shape &s = m_shapes[i], &t = m_shapes[j];
      const auto& points = m_border_points[{i, j}];
      if (!neighbor.is_smooth || points.empty() || !t.has_spine() || s.kind == Kind::FREEFORM)
        continue;
      const Vector center = spine_point(t, points.front());
      if (s.has_spine() &&
          (center - spine_point(s, points.front())).norm() < coincident * t.radius()) {
        if (t.kind != Kind::CYLINDER && add("tangent", i, j, distance_of_spines))
          add("equal radius", i, j, difference_of_radii);
        continue;
      }
      const std::size_t step = 1 + points.size() / 8;
      const double sign = signed_distance(s, center) > 0 ? 1 : -1;
      for (std::size_t k = 0; k < points.size(); k += step)
        add("tangent", i, j, [p = points[k], sign](const Shape& first, const Shape& second) {
          return number(signed_distance(first, spine_point(second, p)) - sign * second.radius());
        });
    }
}

void Design::find_relations()
{
  linearize();
  m_error = error_of_points();
  Faces by_area(m_shapes.size());
  std::iota(by_area.begin(), by_area.end(), 0);
  std::stable_sort(by_area.begin(), by_area.end(),
                   [&](std::size_t i, std::size_t j) { return m_faces[i].area > m_faces[j].area; });
  find_directions(by_area);
  for (const Faces& group : m_parallel) {
    Faces planes, axes;
    for (const std::size_t face : group)
      if (m_shapes[face].has_axis()) {
        if (!add_to_one("coaxial", axes, face, distance_of_axes))
          axes.push_back(face);
      } else if (!add_to_one("coplanar", planes, face, height))
        planes.push_back(face);
    for (const std::size_t face : by_area)
      if (m_shapes[face].kind == Kind::SPHERE)
        add_to_one("coaxial", axes, face, distance_of_axes);
  }
  Faces radii;
  for (const std::size_t face : by_area)
    if (m_shapes[face].has_spine() && !add_to_one("equal radius", radii, face, difference_of_radii))
      radii.push_back(face);
  find_tangent_faces();
}

/// The move of all numbers by which the linear equations of distances and of relations, these of a
/// large weight, have least squares.
Eigen::VectorXd Design::move() const
{
  constexpr double weight = 1e8; // of the square of a residual
  const auto n = Eigen::Index(m_shapes.size()) * size_of_shape;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  const auto add_block = [&](std::size_t i, std::size_t j, const Eigen::MatrixXd& block) {
    for (int k = 0; k < size_of_shape; ++k)
      for (int l = 0; l < size_of_shape; ++l)
        entries.emplace_back(int(i) * size_of_shape + k, int(j) * size_of_shape + l, block(k, l));
  };
  for (std::size_t i = 0; i < m_shapes.size(); ++i) {
    add_block(i, i, m_squares[i]);
    right.segment<size_of_shape>(Eigen::Index(i) * size_of_shape) -= m_slopes[i];
  }
  for (const Relation& relation : m_relations) {
    const std::size_t faces[] = {relation.name.first, relation.name.second};
    const Shape &s = m_shapes[faces[0]], &t = m_shapes[faces[1]];
    const Eigen::VectorXd r = relation.residual(s, t);
    const Eigen::MatrixXd slopes = slopes_of(relation.residual, s, t),
                          squares = weight * slopes.transpose() * slopes;
    for (int i = 0; i < 2; ++i) {
      const Eigen::MatrixXd own = slopes.middleCols(i * size_of_shape, size_of_shape);
      right.segment<size_of_shape>(Eigen::Index(faces[i]) * size_of_shape) -= weight *
                                                                              own.transpose() * r;
      for (int j = 0; j < 2; ++j)
        add_block(
          faces[i], faces[j],
          squares.block<size_of_shape, size_of_shape>(i * size_of_shape, j * size_of_shape));
    }
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right);
}

void Design::solve()
{
  constexpr int steps = 8;
  for (int step = 0; step < steps; ++step) {
    linearize();
    const Eigen::VectorXd moves = move();
    for (std::size_t i = 0; i < m_shapes.size(); ++i) {
      m_shapes[i].x += moves.segment<size_of_shape>(Eigen::Index(i) * size_of_shape);
      m_shapes[i].x.segment<3>(3).normalize();
      move_back_along_axis(m_shapes[i], m_found[i].point());
    }
  }
}

/// How far a relation is from holding, in rounding errors.
double Design::error_of(const Relation& r) const
{
  constexpr double rounding = 1e-8;
  const Shape &s = m_shapes[r.name.first], &t = m_shapes[r.name.second];
  return r.residual(s, t).cwiseAbs().maxCoeff() / rounding;
}

/// How far the points of a surface are from it, by what they may be.
double Design::error_of(std::size_t face) const
{
  constexpr double most = 2, errors = 6;
  if (m_shapes[face].kind == Kind::FREEFORM)
    return 0;
  return deviation(face) /
         (std::max)(most * m_faces[face].surface.deviation / m_size, errors * m_error);
}

bool Design::drop_wrong_relations()
{
  const auto drop = [&](const auto& error) {
    double worst = 1;
    for (const Relation& r : m_relations)
      worst = (std::max)(worst, error(r));
    const auto first = std::remove_if(
      m_relations.begin(), m_relations.end(),
      [&](const Relation& r) { return error(r) > (std::max)(1.0, worst / 2); });
    const bool result = first != m_relations.end();
    m_relations.erase(first, m_relations.end());
    return result;
  };
  const bool dropped = drop([&](const Relation& r) { return error_of(r); }) ||
                       drop([&](const Relation& r) {
                         return (std::max)(error_of(r.name.first), error_of(r.name.second));
                       });
  if (dropped)
    m_shapes = m_found;
  return dropped;
}

void Design::write(Part_faces& faces) const
{
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Shape& s = m_shapes[i];
    if (s.kind == Kind::FREEFORM)
      continue;
    Fitted_surface& surface = faces[i].surface;
    const Vector p = m_center + m_size * s.point(), d = s.direction();
    surface.point = {p.x(), p.y(), p.z()};
    surface.direction = {d.x(), d.y(), d.z()};
    surface.radius = m_size * s.x[6];
    surface.minor_radius = m_size * s.x[7];
    surface.angle = s.x[8];
    surface.deviation = m_size * deviation(i);
    surface.lowest = std::numeric_limits<double>::infinity();
    surface.highest = -surface.lowest;
    for (const Vector& q : m_points[i]) {
      const double z = m_size * (q - s.point()).dot(d);
      surface.lowest = (std::min)(surface.lowest, z);
      surface.highest = (std::max)(surface.highest, z);
    }
  }
}

} // namespace

Design_log set_design_intent(const Mesh& mesh, const Labels& face_of_triangle, Part_faces& faces)
{
  Design_log result;
  for (const auto& face : faces)
    result.as_found.push_back(face.surface);
  Design design(mesh, face_of_triangle, faces);
  design.find_relations();
  design.solve();
  while (design.drop_wrong_relations())
    design.solve();
  std::set<std::tuple<std::string, std::size_t, std::size_t>> told;
  for (const Relation& relation : design.relations())
    if (const auto& [name, i, j] = relation.name;
        told.emplace(name, (std::min)(i, j), (std::max)(i, j)).second)
      result.relations.push_back(relation.name);
  design.write(faces);
  return result;
}

} // namespace mesh_to_step
