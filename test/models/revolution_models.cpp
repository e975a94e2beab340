// SPDX-License-Identifier: GPL-3.0-or-later

#include "models/revolution_models.h"

#include "models/Quad_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace segment_mesh {

namespace {

/// A place on the profile: at a height, at a distance from the axis.
struct Place
{
  double radius, height;
};

/// A piece of the profile, from the end of the piece before.
struct Stretch
{
  Place end;
  double bulge; ///< how far its middle is outside of the straight line
  std::size_t part;
};

struct Profile
{
  double lowest;                  ///< where it leaves the axis
  std::vector<Stretch> stretches; ///< with the outside to the right; the last returns to the axis
};

/// On a circular arc from `start` to the end of the stretch, at t in [0, 1] of its length.
Place place_on(const Place& start, const Stretch& stretch, double t)
{
  const double across = stretch.end.radius - start.radius, up = stretch.end.height - start.height;
  const double chord = std::hypot(across, up),
               half_angle = 2 * std::atan2(2 * stretch.bulge, chord);
  double along = t, outwards = 0; // in chords
  if (stretch.bulge != 0) {
    const double angle = (2 * t - 1) * half_angle, radius = 0.5 / std::sin(half_angle);
    along = 0.5 + radius * std::sin(angle);
    outwards = radius * (std::cos(angle) - std::cos(half_angle));
  }
  return {start.radius + along * across + outwards * up,
          start.height + along * up - outwards * across};
}

/// Puts rings of quads around an axis, bottom up.
class Lathe
{
public:
  Lathe(std::size_t sectors, double lowest)
    : m_sectors(sectors)
  {
    m_model.soup.points.push_back({0, 0, lowest});
  }

  /// A ring of points, and the faces between it and the points before.
  void add_ring(const Place& place, std::size_t part)
  {
    const double full_turn = 6.283185307179586;
    const bool is_first = m_model.soup.points.size() == 1;
    const std::size_t ring = m_model.soup.points.size();
    for (std::size_t i = 0; i < m_sectors; ++i) {
      const double angle = full_turn * double(i) / double(m_sectors);
      m_model.soup.points.push_back(
        {place.radius * std::cos(angle), place.radius * std::sin(angle), place.height});
      const std::size_t a = ring + i, b = ring + (i + 1) % m_sectors;
      if (is_first)
        add_face({0, b, a}, part);
      else
        add_face({a - m_sectors, b - m_sectors, b, a}, part);
    }
  }

  Labelled_model close(double highest, std::size_t part)
  {
    const std::size_t top = m_model.soup.points.size(), ring = top - m_sectors;
    m_model.soup.points.push_back({0, 0, highest});
    for (std::size_t i = 0; i < m_sectors; ++i)
      add_face({ring + i, ring + (i + 1) % m_sectors, top}, part);
    return m_model;
  }

private:
  void add_face(std::initializer_list<std::size_t> face, std::size_t part)
  {
    m_model.soup.polygons.push_back(face);
    m_model.labels.push_back(part);
    m_model.number_of_parts = (std::max)(m_model.number_of_parts, part + 1);
  }

  std::size_t m_sectors;
  Labelled_model m_model;
};

struct Spacing
{
  double sectors; ///< their number
  double step;    ///< about the distance of the rings along the profile

  Spacing(double usual_sectors, double usual_step, const Making& making)
    : sectors(usual_sectors * making.fineness)
    , step(usual_step / making.fineness)
  {}
};

Labelled_model turn(const char* name, const Profile& profile, const Spacing& spacing)
{
  Lathe lathe(std::size_t(std::lround(spacing.sectors)), profile.lowest);
  Place start = {0, profile.lowest};
  for (const Stretch& stretch : profile.stretches) {
    const double length = std::hypot(stretch.end.radius - start.radius,
                                     stretch.end.height - start.height);
    const std::size_t steps = (std::max)(std::size_t(1),
                                         std::size_t(std::lround(length / spacing.step)));
    const bool is_last = &stretch == &profile.stretches.back();
    for (std::size_t i = 1; i <= steps - is_last; ++i)
      lathe.add_ring(place_on(start, stretch, double(i) / double(steps)), stretch.part);
    start = stretch.end;
  }
  Labelled_model model = lathe.close(start.height, profile.stretches.back().part);
  model.name = name;
  return model;
}

} // namespace

Labelled_model make_vase(const Making& making)
{
  const Profile profile = {0,
                           {{{0.5, 0}, 0, 0},
                            {{0.28, 0.3}, -0.06, 0},
                            {{0.25, 1.6}, 0.5, 1},
                            {{0.42, 2.1}, -0.07, 2},
                            {{0, 2.1}, 0, 2}}};
  return turn("vase", profile, {40, 0.06, making});
}

Labelled_model make_goblet(const Making& making)
{
  const Profile profile = {0,
                           {{{0.6, 0}, 0, 0},
                            {{0.6, 0.08}, 0, 0},
                            {{0.1, 0.2}, 0, 0},
                            {{0.1, 1.1}, 0, 1},
                            {{0.6, 1.9}, 0.22, 2},
                            {{0.52, 1.9}, 0, 2},
                            {{0, 1.2}, -0.25, 2}}};
  Labelled_model model = turn("goblet", profile, {36, 0.05, making});
  split_quads(model, Diagonals::AT_RANDOM);
  add_noise(model, making.noise * 0.006 / making.fineness);
  return model;
}

Labelled_model make_snowman(const Making& making)
{
  const Profile profile = {
    0, {{{0.38, 1.288}, 0.502, 0}, {{0.28, 2.027}, 0.167, 1}, {{0, 2.613}, 0.2045, 2}}};
  Labelled_model model = turn("snowman", profile, {48, 0.06, making});
  split_quads(model, Diagonals::ALTERNATING);
  add_noise(model, making.noise * 0.004 / making.fineness);
  return model;
}

Labelled_model make_shaft(const Making& making)
{
  const Profile profile = {0,
                           {{{0.3, 0}, 0, 0},
                            {{0.3, 1}, 0, 0},
                            {{0.65, 1}, 0, 1},
                            {{0.65, 1.3}, 0, 1},
                            {{0.4, 1.3}, 0, 1},
                            {{0.4, 2.5}, 0, 2},
                            {{0.65, 2.5}, 0, 3},
                            {{0.65, 2.8}, 0, 3},
                            {{0.2, 2.8}, 0, 3},
                            {{0.2, 3.6}, 0, 4},
                            {{0, 3.6}, 0, 4}}};
  Labelled_model model = turn("shaft", profile, {20, 0.15, making});
  split_quads(model, Diagonals::FIRST);
  return model;
}

Labelled_model make_screwdriver(const Making& making)
{
  const Profile profile = {0,
                           {{{0.3, 0.15}, 0.08, 0},
                            {{0.3, 1.3}, 0.06, 0},
                            {{0.1, 1.5}, 0.03, 0},
                            {{0.1, 3.4}, 0, 1},
                            {{0.05, 3.6}, 0, 1},
                            {{0, 3.6}, 0, 1}}};
  Labelled_model model = turn("screwdriver", profile, {32, 0.1, making});
  split_quads(model, Diagonals::FIRST);
  return model;
}

} // namespace segment_mesh
