// SPDX-License-Identifier: GPL-3.0-or-later

#include "models/articulated_figure.h"

#include "models/Implicit_shape.h"

namespace segment_mesh {

namespace {

/// An ellipsoid from end to end. Arms reach along x, z is up, the figure is 3.4 high.
struct Limb
{
  double from[3], to[3], radius;
};

constexpr Limb trunk_and_head[] = {{{0, 0, -0.1}, {0, 0, 1.25}, 0.38},
                                   {{0, 0, 1.1}, {0, 0, 1.75}, 0.27}};

/// Those of the right side; each has a mirror image, which is a part of its own.
constexpr Limb side[] = {{{0.28, 0, 0.98}, {0.95, 0, 0.75}, 0.16},
                         {{0.85, 0, 0.8}, {1.5, 0.2, 0.95}, 0.13},
                         {{0.15, 0, 0.2}, {0.3, 0, -0.8}, 0.2},
                         {{0.29, 0, -0.7}, {0.38, -0.05, -1.6}, 0.16}};

Distance body(const Limb& limb, double mirror)
{
  return ellipsoid({mirror * limb.from[0], limb.from[1], limb.from[2]},
                   {mirror * limb.to[0], limb.to[1], limb.to[2]}, limb.radius);
}

} // namespace

Labelled_model make_articulated_figure(const Making& making)
{
  const double softness_of_joints = 0.06, edge_length = 0.048 / making.fineness;
  Implicit_shape shape(softness_of_joints);
  std::size_t part = 0;
  for (const Limb& limb : trunk_and_head)
    shape.add(body(limb, 1), part++);
  for (const Limb& limb : side)
    for (const double mirror : {1.0, -1.0})
      shape.add(body(limb, mirror), part++);

  Labelled_model model = make_labelled_model(shape, {0, 0, 0.3}, edge_length);
  model.name = articulated_figure;
  return model;
}

} // namespace segment_mesh
