// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LOFT_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LOFT_H

#include "models/Labelled_model.h"

#include <complex>
#include <cstddef>
#include <vector>

namespace segment_mesh {

/// A point or vector of a plane.
using Planar = std::complex<double>;

/// A line or circular arc.
struct Planar_piece
{
  Planar from, to;
  double turn = 0; ///< by which the tangent turns to the left, in radians; 0: a line

  Planar at(double t) const;      ///< t in [0, 1], by arc length
  Planar tangent(double t) const; ///< of length 1
  double length() const;
};

using Planar_curve = std::vector<Planar_piece>;

/// Part of the vertical section of a solid, on the way from the axis below to the axis above.
struct Wall
{
  enum Kind {
    OUTER, ///< real part: the distance inwards from the outline; imaginary part: the height
    CAP,   ///< plane, from the outline to the bore or back: `line` is not used
    BORE   ///< real part: the distance outwards from the bore; imaginary part: the height
  };
  Kind kind;
  Planar_piece line = {};
};

/// A solid between an outline, swept along walls, and a round bore along the z axis (of radius 0:
/// none). Each piece of the outline makes a face with each outer wall that is not horizontal.
struct Loft
{
  Planar_curve outline; ///< closed, counterclockwise, and star-shaped around the origin
  double bore;
  std::vector<Wall> walls; ///< closed: begins with the cap below
};

/// How curved faces become triangles.
struct Tessellation
{
  double angle;       ///< the largest turn along an edge, in degrees
  double edge_length; ///< the longest edge, about
  double jitter; ///< how far points move at random along their face, relative to the edges; below
                 ///< 0.5
};

/// The surface of a solid; the parts are its faces.
Labelled_model tessellate(const Loft& loft, const Tessellation& tessellation);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_LOFT_H
