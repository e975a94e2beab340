// SPDX-License-Identifier: GPL-3.0-or-later

#include "design_intent.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Region_segmentation/Part_faces/internal/fit_surface.h>
#include <CGAL/boost/graph/iterator.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace mesh_to_step {

namespace {

namespace internal = RS::internal;
using Kind = RS::Surface_kind;
using Vector = RS::Double_3;
/// A surface of a part of size 1.
using Shape = RS::Fitted_surface<>;
using Move = internal::Surface_vector;
using Square = internal::Surface_matrix;

constexpr int size_of_move = Move::RowsAtCompileTime;
constexpr double rounding = 1e-8;

using Kinds = std::set<Kind>;
const Kinds with_axis{Kind::CYLINDER, Kind::CONE, Kind::TORUS},
  with_direction{Kind::PLANE, Kind::CYLINDER, Kind::CONE, Kind::TORUS},
  with_spine{Kind::CYLINDER, Kind::SPHERE, Kind::TORUS};

/// Whether the surface has one distance from its spine: a point, line or circle.
bool has_spine(const Shape& s)
{
  return with_spine.count(s.kind) > 0;
}

/// The distance of a surface from its spine.
double radius(const Shape& s)
{
  return s.kind == Kind::TORUS ? s.minor_radius : s.radius;
}

double signed_distance(const Shape& s, const Vector& p)
{
  return internal::Surface_distance(s)(p);
}

/// The point of the spine next to `p`.
Vector spine_point(const Shape& s, const Vector& p)
{
  return p - (s.side * (signed_distance(s, p) + radius(s))) * internal::surface_normal(s, p);
}

Eigen::Vector3d vector(const Vector& v)
{
  return {v.x, v.y, v.z};
}

double largest(const Vector& v)
{
  return vector(v).lpNorm<Eigen::Infinity>();
}

/// A function of two surfaces that is 0 where a relation of them holds; of one number, it is the
/// first.
using Residual = std::function<Vector(const Shape&, const Shape&)>;

Vector cross_of_directions(const Shape& s, const Shape& t)
{
  return cross(s.direction, t.direction);
}

Vector dot_of_directions(const Shape& s, const Shape& t)
{
  return {dot(s.direction, t.direction), 0, 0};
}

/// The vector from the axis of the first surface to the point of the second one.
Vector distance_of_axes(const Shape& s, const Shape& t)
{
  const Vector d = t.point - s.point;
  return d - dot(d, s.direction) * s.direction;
}

Vector height(const Shape& s, const Shape& t)
{
  return {dot(t.point - s.point, s.direction), 0, 0};
}

Vector difference_of_radii(const Shape& s, const Shape& t)
{
  return {radius(t) - radius(s), 0, 0};
}

double angle_of_directions(const Shape& s, const Shape& t)
{
  return std::acos(std::clamp(dot(s.direction, t.direction), -1.0, 1.0));
}

/// The derivatives of a residual by moves of the first surface, and by those of the second.
using Slopes = Eigen::Matrix<double, 3, 2 * size_of_move, Eigen::DontAlign>;

Slopes slopes_of(const Residual& residual, const Shape& s, const Shape& t)
{
  constexpr double step = 1e-6;
  const internal::Surface_derivatives first(s), second(t);
  Slopes result;
  const auto set_column = [&](int i, const Vector& above, const Vector& below) {
    result.col(i) = vector((1 / (2 * step)) * (above - below));
  };
  for (int i = 0; i < size_of_move; ++i) {
    const Move d = step * Move::Unit(i);
    set_column(i, residual(first.moved(d), t), residual(first.moved(-d), t));
    set_column(size_of_move + i, residual(s, second.moved(d)), residual(s, second.moved(-d)));
  }
  return result;
}

/// A number of a design, of one surface or two.
struct Number
{
  std::function<double(const Shape&, const Shape&)> value; ///< angles in radians
  bool is_angle = false;
};

struct Relation
{
  Relation_of_faces name;
  Residual residual;
};

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
  using Faces = std::vector<std::size_t>;

  Vector in_unit(const Point& p) const;
  double error_of(const Relation& r) const;
  double error_of(std::size_t face) const;
  void linearize();
  double error_of_points() const;
  bool add(const Relation& relation, double most_error);
  bool add(const std::string& name, std::size_t first, std::size_t second,
           const Residual& residual);
  bool add_round(const std::string& name, std::size_t first, std::size_t second,
                 const Number& number);
  std::vector<Faces> relate(const std::string& name, const Faces& faces, const Residual& residual);
  Faces those(const Faces& faces, const Kinds& kinds) const;
  void find_angles(const std::vector<Faces>& parallel);
  void find_places(const std::vector<Faces>& parallel, const Faces& spheres);
  void find_sizes(const Faces& by_area);
  void find_tangent_faces();
  Eigen::VectorXd move() const;

  const Part_faces& m_faces;
  Point m_center;
  double m_size;
  std::vector<Shape> m_shapes;
  std::vector<Shape> m_found; ///< the shapes before any was moved
  std::vector<std::vector<Vector>> m_points;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Vector>> m_border_points;
  std::vector<Square> m_squares; ///< of the derivatives of distances, damped
  std::vector<Move> m_slopes;    ///< of half the sum of the squared distances
  double m_cost = 0;             ///< that sum
  double m_error = 0;            ///< of a point: the standard deviation
  std::vector<Relation> m_relations;
};

Design::Design(const Mesh& mesh, const Labels& labels, const Part_faces& faces)
  : m_faces(faces)
  , m_points(faces.size())
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const Point low(box.xmin(), box.ymin(), box.zmin()), high(box.xmax(), box.ymax(), box.zmax());
  m_center = CGAL::midpoint(low, high);
  m_size = std::sqrt(CGAL::squared_distance(low, high));
  for (const auto& face : faces) {
    const Fitted_surface& s = face.surface;
    Shape shape = internal::surface_of_kind(s.kind, in_unit(s.point),
                                            {s.direction.x(), s.direction.y(), s.direction.z()});
    shape.radius = s.radius / m_size;
    shape.minor_radius = s.minor_radius / m_size;
    shape.angle = s.angle;
    shape.side = s.side;
    m_shapes.push_back(shape);
  }
  m_found = m_shapes;
  for (auto v : vertices(mesh)) {
    std::set<std::size_t> around;
    for (auto f : faces_around_target(halfedge(v, mesh), mesh))
      if (f != Mesh::null_face())
        around.insert(labels[f]);
    for (const std::size_t face : around) {
      m_points[face].push_back(in_unit(mesh.point(v)));
      for (const std::size_t other : around)
        m_border_points[{face, other}].push_back(m_points[face].back());
    }
  }
}

Vector Design::in_unit(const Point& p) const
{
  const Kernel::Vector_3 d = (p - m_center) / m_size;
  return {d.x(), d.y(), d.z()};
}

/// Writes the equations of least squares of each surface.
void Design::linearize()
{
  constexpr double damping = 1e-7;
  m_squares.assign(m_shapes.size(), damping * Square::Identity());
  m_slopes.assign(m_shapes.size(), Move::Zero());
  m_cost = 0;
  for (std::size_t i = 0; i < m_shapes.size(); ++i)
    if (m_shapes[i].kind != Kind::FREEFORM) {
      const internal::Surface_derivatives derivatives(m_shapes[i]);
      Move slope;
      for (const Vector& p : m_points[i]) {
        const double d = derivatives(p, slope);
        m_squares[i] += slope * slope.transpose();
        m_slopes[i] += d * slope;
        m_cost += d * d;
      }
    }
}

/// The standard deviation of a distance, of those of all points.
double Design::error_of_points() const
{
  double freedom = 1;
  for (std::size_t i = 0; i < m_shapes.size(); ++i)
    if (m_shapes[i].kind != Kind::FREEFORM)
      freedom += (std::max)(0.0, double(m_points[i].size()) -
                                   internal::degrees_of_freedom(m_shapes[i].kind));
  return (std::max)(rounding, std::sqrt(m_cost / freedom));
}

/// Adds a relation that holds within four standard errors, if these are small enough.
bool Design::add(const Relation& relation, double most_error)
{
  constexpr double errors = 4;
  const auto& [name, residual] = relation;
  const Shape &s = m_shapes[name.first], &t = m_shapes[name.second];
  const Slopes slopes = slopes_of(residual, s, t);
  Eigen::Vector3d variance = Eigen::Vector3d::Zero();
  for (const auto& [face, column] : {std::make_pair(name.first, 0), {name.second, size_of_move}}) {
    const auto own = slopes.middleCols<size_of_move>(column);
    variance += (own * m_squares[face].inverse() * own.transpose()).diagonal();
  }
  const Eigen::Array3d error = rounding + errors * m_error * variance.array().sqrt();
  if (error[0] > most_error || (vector(residual(s, t)).array().abs() > error).any())
    return false;
  m_relations.push_back(relation);
  return true;
}

bool Design::add(const std::string& name, std::size_t first, std::size_t second,
                 const Residual& residual)
{
  constexpr double most = 0.01, any = std::numeric_limits<double>::infinity();
  return largest(residual(m_shapes[first], m_shapes[second])) < most &&
         add({{name, first, second}, residual}, any);
}

/// Adds the relation that a number, which is not 0, is the next round one.
bool Design::add_round(const std::string& name, std::size_t first, std::size_t second,
                       const Number& number)
{
  const double unit = number.is_angle ? 180 / CGAL_PI : m_size, step = number.is_angle ? 0.5 : 0.01;
  const double from = unit * number.value(m_shapes[first], m_shapes[second]),
               to = step * std::round(from / step);
  const Residual residual = [=, value = number.value](const Shape& s, const Shape& t) {
    return Vector{value(s, t) - to / unit, 0, 0};
  };
  return to != 0 && std::fabs(from - to) < step / 10 &&
         add({{name, first, second, from, to}, residual}, step / 10 / unit);
}

/// Groups faces: each gets the relation to the first face of a group, or begins a group.
std::vector<Design::Faces> Design::relate(const std::string& name, const Faces& faces,
                                          const Residual& residual)
{
  std::vector<Faces> groups;
  for (const std::size_t face : faces) {
    const auto group = std::find_if(groups.begin(), groups.end(), [&](const Faces& others) {
      return add(name, others.front(), face, residual);
    });
    if (group == groups.end())
      groups.push_back({face});
    else
      group->push_back(face);
  }
  return groups;
}

/// The faces of these kinds.
Design::Faces Design::those(const Faces& faces, const Kinds& kinds) const
{
  Faces result;
  std::copy_if(faces.begin(), faces.end(), std::back_inserter(result),
               [&](std::size_t face) { return kinds.count(m_shapes[face].kind) > 0; });
  return result;
}

/// Of two surfaces that are tangent, the spine of the second is as far from the first as its
/// radius. (Spines that coincide have other relations: coaxial, equal radius.)
void Design::find_tangent_faces()
{
  constexpr double coincident = 0.1; // of the radius
  for (std::size_t i = 0; i < m_shapes.size(); ++i)
    for (const auto& neighbor : m_faces[i].neighbors) {
      const std::size_t j = neighbor.face;
      const Shape &s = m_shapes[i], &t = m_shapes[j];
      const auto& points = m_border_points[{i, j}];
      if (!neighbor.is_smooth || points.empty() || !has_spine(t) || s.kind == Kind::FREEFORM)
        continue;
      const Vector center = spine_point(t, points.front());
      if (has_spine(s) && norm(center - spine_point(s, points.front())) < coincident * radius(t))
        continue;
      const std::size_t step = 1 + points.size() / 8;
      const double sign = signed_distance(s, center) > 0 ? 1 : -1;
      for (std::size_t k = 0; k < points.size(); k += step)
        add("tangent", i, j, [p = points[k], sign](const Shape& first, const Shape& second) {
          return Vector{signed_distance(first, spine_point(second, p)) - sign * radius(second), 0,
                        0};
        });
    }
}

void Design::find_angles(const std::vector<Faces>& parallel)
{
  for (auto second = parallel.begin(); second != parallel.end(); ++second)
    for (auto first = parallel.begin(); first != second; ++first)
      if (!add("perpendicular", first->front(), second->front(), dot_of_directions))
        add_round("angle", first->front(), second->front(), {angle_of_directions, true});
}

/// Planes and axes that coincide, spheres on axes; distances from the largest plane and axis of
/// each direction, from planes also to axes along them and to spheres.
void Design::find_places(const std::vector<Faces>& parallel, const Faces& spheres)
{
  constexpr double parallel_cosine = 0.01;
  const Number from_plane{[](const Shape&s, const Shape&t) { return std::fabs(height(s, t).x); }},
    from_axis{[](const Shape&s, const Shape&t) { return norm(distance_of_axes(s, t)); }};
  Faces largest_planes, all_axes;
  for (const Faces& faces : parallel) {
    const auto planes = relate("coplanar", those(faces, {Kind::PLANE}), height),
               axes = relate("coaxial", those(faces, with_axis), distance_of_axes);
    for (const Faces& plane : planes)
      add_round("distance", planes.front().front(), plane.front(), from_plane);
    for (const Faces& axis : axes) {
      all_axes.push_back(axis.front());
      add_round("distance", axes.front().front(), axis.front(), from_axis);
      for (const std::size_t sphere : spheres)
        add("coaxial", axis.front(), sphere, distance_of_axes);
    }
    if (!planes.empty())
      largest_planes.push_back(planes.front().front());
  }
  for (const std::size_t plane : largest_planes) {
    for (const std::size_t axis : all_axes)
      if (largest(dot_of_directions(m_shapes[plane], m_shapes[axis])) < parallel_cosine)
        add_round("distance", plane, axis, from_plane);
    for (const std::size_t sphere : spheres)
      add_round("distance", plane, sphere, from_plane);
  }
}

void Design::find_sizes(const Faces& by_area)
{
  relate("equal radius", those(by_area, with_spine), difference_of_radii);
  for (const std::size_t i : by_area) {
    const Kind kind = m_shapes[i].kind;
    if (has_spine(m_shapes[i]))
      add_round("radius", i, i, {[](const Shape& s, const Shape&) { return radius(s); }});
    if (kind == Kind::TORUS)
      add_round("major radius", i, i, {[](const Shape& s, const Shape&) { return s.radius; }});
    if (kind == Kind::CONE)
      add_round("half angle", i, i, {[](const Shape& s, const Shape&) { return s.angle; }, true});
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
  const std::vector<Faces> parallel = relate("parallel", those(by_area, with_direction),
                                             cross_of_directions);
  find_angles(parallel);
  find_places(parallel, those(by_area, {Kind::SPHERE}));
  find_sizes(by_area);
  find_tangent_faces();
}

/// The move of all surfaces by which the linear equations of distances and of relations, these of a
/// large weight, have least squares.
Eigen::VectorXd Design::move() const
{
  constexpr double weight = 1e8; // of the square of a residual
  const auto n = Eigen::Index(m_shapes.size()) * size_of_move;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  const auto add_block = [&](std::size_t i, std::size_t j, const Square& block) {
    for (int k = 0; k < size_of_move; ++k)
      for (int l = 0; l < size_of_move; ++l)
        entries.emplace_back(int(i) * size_of_move + k, int(j) * size_of_move + l, block(k, l));
  };
  const auto add_right = [&](std::size_t i, const Move& x) {
    right.segment<size_of_move>(Eigen::Index(i) * size_of_move) -= x;
  };
  for (std::size_t i = 0; i < m_shapes.size(); ++i) {
    add_block(i, i, m_squares[i]);
    add_right(i, m_slopes[i]);
  }
  for (const Relation& relation : m_relations) {
    const std::size_t faces[] = {relation.name.first, relation.name.second};
    const Shape &s = m_shapes[faces[0]], &t = m_shapes[faces[1]];
    const Eigen::Vector3d r = vector(relation.residual(s, t));
    const Slopes slopes = slopes_of(relation.residual, s, t);
    for (int i = 0; i < 2; ++i) {
      const auto own = slopes.middleCols<size_of_move>(i * size_of_move);
      add_right(faces[i], weight * own.transpose() * r);
      for (int j = 0; j < 2; ++j)
        add_block(faces[i], faces[j],
                  weight * own.transpose() * slopes.middleCols<size_of_move>(j * size_of_move));
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
      const Move own = moves.segment<size_of_move>(Eigen::Index(i) * size_of_move);
      m_shapes[i] = internal::Surface_derivatives(m_shapes[i]).moved(own);
      internal::move_along_axis(m_shapes[i], m_found[i].point);
    }
  }
}

/// How far a relation is from holding, in rounding errors.
double Design::error_of(const Relation& r) const
{
  return largest(r.residual(m_shapes[r.name.first], m_shapes[r.name.second])) / rounding;
}

/// How far the points of a surface are from it, by what they may be.
double Design::error_of(std::size_t face) const
{
  constexpr double most = 2, errors = 6;
  if (m_shapes[face].kind == Kind::FREEFORM)
    return 0;
  return internal::largest_distance(m_shapes[face], m_points[face]) /
         (std::max)(most * m_faces[face].surface.deviation / m_size, errors * m_error);
}

bool Design::drop_wrong_relations()
{
  const auto drop = [&](const auto& error) {
    double worst[] = {1, 1}; // of relations; of round numbers, which give way to these
    for (const Relation& r : m_relations) {
      double& of_kind = worst[r.name.is_round_number()];
      of_kind = (std::max)(of_kind, error(r));
    }
    const bool are_round = worst[1] > 1;
    const auto first = std::remove_if(m_relations.begin(), m_relations.end(),
                                      [&](const Relation& r) {
                                        return r.name.is_round_number() == are_round &&
                                               error(r) > (std::max)(1.0, worst[are_round] / 2);
                                      });
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
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (Shape s = m_shapes[i]; s.kind != Kind::FREEFORM) {
      internal::measure(s, m_points[i]);
      faces[i].surface = RS::scaled<Kernel>(s, m_size);
      faces[i].surface.point += m_center - CGAL::ORIGIN;
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
    if (const Relation_of_faces& r = relation.name;
        told.emplace(r.name, (std::min)(r.first, r.second), (std::max)(r.first, r.second)).second)
      result.relations.push_back(r);
  design.write(faces);
  return result;
}

} // namespace mesh_to_step
