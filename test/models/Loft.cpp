// SPDX-License-Identifier: GPL-3.0-or-later

#include "models/Loft.h"

#include "models/Quad_model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace segment_mesh {

namespace {

constexpr double pi = 3.141592653589793;

double dot(const Planar& v, const Planar& w)
{
  return std::real(std::conj(v) * w);
}

/// A place on a curve.
struct Station
{
  std::size_t piece;
  double t;       // in [0, 1] along the piece
  double spacing; // of stations, in t
  bool is_end;    // of a piece
};

std::vector<Station> stations(const std::vector<std::size_t>& steps)
{
  std::vector<Station> result;
  for (std::size_t piece = 0; piece < steps.size(); ++piece)
    for (std::size_t i = 0; i < steps[piece]; ++i)
      result.push_back({piece, double(i) / double(steps[piece]), 1 / double(steps[piece]), i == 0});
  return result;
}

/// A grid of points, station of the outline by station of the walls, and its quads.
class Grid
{
public:
  Grid(const Loft& loft, const Tessellation& tessellation)
    : m_loft(loft)
    , m_tessellation(tessellation)
    , m_along(stations(steps_along()))
    , m_up(stations(steps_up()))
  {}

  Labelled_model surface()
  {
    for (std::size_t i = 0; i < m_along.size(); ++i)
      for (std::size_t j = 0; j < m_up.size(); ++j)
        m_point_at.push_back(add_point(m_along[i], m_up[j]));
    for (std::size_t i = 0; i < m_along.size(); ++i)
      for (std::size_t j = 0; j < m_up.size(); ++j)
        add_quad(i, j);
    return std::move(m_model);
  }

private:
  std::size_t number_of_steps(double turn, double length) const
  {
    const double by_angle = std::abs(turn) / (m_tessellation.angle * pi / 180),
                 by_length = length / m_tessellation.edge_length;
    const double margin = 1e-9; // of rounding
    return std::size_t((std::max)(1.0, std::ceil((std::max)(by_angle, by_length) - margin)));
  }

  /// A bore needs as many steps as a circle has.
  std::vector<std::size_t> steps_along() const
  {
    std::vector<std::size_t> result;
    for (const Planar_piece& piece : m_loft.outline) {
      const double turn_of_bore = m_loft.bore > 0 ? std::arg(piece.to / piece.from) : 0;
      result.push_back(
        number_of_steps((std::max)(std::abs(piece.turn), std::abs(turn_of_bore)), piece.length()));
    }
    return result;
  }

  std::vector<std::size_t> steps_up() const
  {
    std::vector<std::size_t> result;
    for (const Wall& wall : m_loft.walls)
      result.push_back(wall.kind == Wall::CAP
                         ? number_of_steps(0, std::abs(m_loft.outline[0].from) - m_loft.bore)
                       : wall.kind == Wall::BORE && m_loft.bore == 0
                         ? 1 // vanishes
                         : number_of_steps(wall.line.turn, wall.line.length()));
    return result;
  }

  /// The first of the consecutive pieces of one circle.
  std::size_t side_of(std::size_t piece) const
  {
    const auto curvature = [this](std::size_t i) {
      return m_loft.outline[i].turn / m_loft.outline[i].length();
    };
    while (piece > 0 && curvature(piece) != 0 && curvature(piece) == curvature(piece - 1))
      --piece;
    return piece;
  }

  double jittered(const Station& station)
  {
    if (station.is_end)
      return station.t;
    const double random = 2 * (double(m_engine()) / double(std::mt19937::max())) - 1;
    return station.t + m_tessellation.jitter * random * station.spacing;
  }

  /// Inwards; at a corner of the outline, such that both sides are at distance 1.
  Planar offset(const Station& along, double t) const
  {
    const Planar left(0, 1), after = left * m_loft.outline[along.piece].tangent(t);
    if (!along.is_end)
      return after;
    const std::size_t size = m_loft.outline.size();
    const Planar before = left * m_loft.outline[(along.piece + size - 1) % size].tangent(1);
    return (before + after) / (1 + dot(before, after));
  }

  Point place(const Station& along, double t, Wall::Kind kind, const Planar& on_wall) const
  {
    const Planar on_outline = m_loft.outline[along.piece].at(t);
    const Planar p = kind == Wall::OUTER
                       ? on_outline + on_wall.real() * offset(along, t)
                       : on_outline / std::abs(on_outline) * (m_loft.bore + on_wall.real());
    return {p.real(), p.imag(), on_wall.imag()};
  }

  std::size_t add_point(const Station& along, const Station& up)
  {
    const double t = jittered(along), s = jittered(up);
    const Wall& wall = m_loft.walls[up.piece];
    if (wall.kind != Wall::CAP)
      return point_at(place(along, t, wall.kind, wall.line.at(s)));
    const std::size_t size = m_loft.walls.size();
    const Wall &before = m_loft.walls[(up.piece + size - 1) % size],
               &after = m_loft.walls[(up.piece + 1) % size];
    const Point a = end_of(before, along, t, 1), b = end_of(after, along, t, 0);
    return point_at(
      {(1 - s) * a[0] + s * b[0], (1 - s) * a[1] + s * b[1], (1 - s) * a[2] + s * b[2]});
  }

  Point end_of(const Wall& wall, const Station& along, double t, double s) const
  {
    return place(along, t, wall.kind, wall.line.at(s));
  }

  /// Points of a face that degenerates to a point are one.
  std::size_t point_at(const Point& p)
  {
    const double tolerance = 1e-7;
    std::array<long, 3> key;
    for (std::size_t i = 0; i < 3; ++i)
      key[i] = std::lround(p[i] / tolerance);
    const auto entry = m_point_of.emplace(key, m_model.soup.points.size());
    if (entry.second)
      m_model.soup.points.push_back(p);
    return entry.first->second;
  }

  std::size_t face_of(const Station& along, const Station& up)
  {
    const Wall& wall = m_loft.walls[up.piece];
    const bool is_split = wall.kind == Wall::OUTER &&
                          (wall.line.from.imag() != wall.line.to.imag() || wall.line.turn != 0);
    const auto entry = m_face_of.emplace(
      std::make_pair(up.piece, is_split ? side_of(along.piece) : 0), m_face_of.size());
    m_model.number_of_parts = m_face_of.size();
    return entry.first->second;
  }

  void add_quad(std::size_t i, std::size_t j)
  {
    const std::size_t rows = m_up.size(), next_i = (i + 1) % m_along.size(),
                      next_j = (j + 1) % rows;
    std::vector<std::size_t> corners;
    for (const std::size_t p : {m_point_at[i * rows + j], m_point_at[next_i * rows + j],
                                m_point_at[next_i * rows + next_j], m_point_at[i * rows + next_j]})
      if (std::find(corners.begin(), corners.end(), p) == corners.end())
        corners.push_back(p);
    if (corners.size() < 3)
      return;
    m_model.soup.polygons.push_back(corners);
    m_model.labels.push_back(face_of(m_along[i], m_up[j]));
  }

  const Loft& m_loft;
  const Tessellation& m_tessellation;
  std::vector<Station> m_along, m_up;
  std::mt19937 m_engine;
  std::vector<std::size_t> m_point_at;
  std::map<std::array<long, 3>, std::size_t> m_point_of;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> m_face_of;
  Labelled_model m_model;
};

} // namespace

// The chord to t subtends the angle t * turn.
Planar Planar_piece::at(double t) const
{
  if (turn == 0)
    return from + t * (to - from);
  return from +
         (to - from) * std::polar(std::sin(turn * t / 2) / std::sin(turn / 2), turn * (t - 1) / 2);
}

Planar Planar_piece::tangent(double t) const
{
  return (to - from) / std::abs(to - from) * std::polar(1.0, turn * (t - 0.5));
}

double Planar_piece::length() const
{
  const double chord = std::abs(to - from);
  return turn == 0 ? chord : chord * turn / (2 * std::sin(turn / 2));
}

Labelled_model tessellate(const Loft& loft, const Tessellation& tessellation)
{
  Labelled_model model = Grid(loft, tessellation).surface();
  split_quads(model, tessellation.jitter > 0 ? Diagonals::ALTERNATING : Diagonals::FIRST);
  return model;
}

} // namespace segment_mesh
