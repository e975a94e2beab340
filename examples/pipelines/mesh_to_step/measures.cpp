// SPDX-License-Identifier: GPL-3.0-or-later

#include "measures.h"

#include <Geom_Plane.hxx>

namespace mesh_to_step {

namespace {

gp_Pnt midpoint(const gp_Pnt& p, const gp_Pnt& q)
{
  return (p.XYZ() + q.XYZ()) / 2;
}

Measures measures(const std::array<gp_Pnt, 3>& c)
{
  const gp_Vec normal = gp_Vec(c[0], c[1]) ^ gp_Vec(c[0], c[2]);
  return {normal.Magnitude() / 2, normal.Dot(gp_Vec(c[0].XYZ())) / 6};
}

/// The sum over the triangles after `depth` divisions of each into four.
Measures measures(const std::array<gp_Pnt, 3>& c, const Surfaces& surface,
                  const std::array<Curve_piece, 3>& sides, int depth)
{
  if (depth == 0)
    return measures(c);
  std::array<gp_Pnt, 3> middles;
  std::array<Curve_piece, 3> firsts, lasts;
  for (std::size_t i = 0; i < 3; ++i) {
    const Curve_piece& s = sides[i];
    const bool is_inside = s.curve.IsNull();
    middles[i] = is_inside ? nearest_point(surface, midpoint(c[i], c[(i + 1) % 3])) : s.point(0.5);
    firsts[i] = {s.curve, s.first, (s.first + s.last) / 2};
    lasts[i] = {s.curve, firsts[i].last, s.last};
  }
  Measures sum = measures(middles, surface, {}, depth - 1);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t before = (i + 2) % 3;
    const Measures part = measures({c[i], middles[i], middles[before]}, surface,
                                   {firsts[i], {}, lasts[before]}, depth - 1);
    sum.area += part.area;
    sum.volume += part.volume;
  }
  return sum;
}

} // namespace

Measures measures_on_surface(const std::array<gp_Pnt, 3>& corners, const Surfaces& surface,
                             const std::array<Curve_piece, 3>& sides)
{
  const bool is_flat = surface.empty() || surface[0]->Surface()->IsKind(STANDARD_TYPE(Geom_Plane));
  if (is_flat && sides[0].curve.IsNull() && sides[1].curve.IsNull() && sides[2].curve.IsNull())
    return measures(corners);
  const Measures coarse = measures(corners, surface, sides, 1),
                 fine = measures(corners, surface, sides, 2);
  // The error is as the square of the length of a side.
  return {fine.area + (fine.area - coarse.area) / 3,
          fine.volume + (fine.volume - coarse.volume) / 3};
}

} // namespace mesh_to_step
