// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_HOLES_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_HOLES_H

#include "part_mesh.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace mesh_to_step {

/// Walls around one axis that lead into each other.
struct Hole
{
  struct Counterbore
  {
    double diameter, depth;
  };
  struct Countersink
  {
    double diameter, angle; ///< of the wider end; between opposite lines, in degrees
  };

  std::vector<std::size_t> walls;        ///< cylinders and cones
  double diameter = 0;                   ///< of the narrowest wall
  double depth = 0;                      ///< of all walls but a tip
  bool is_blind = false;                 ///< whether it ends in the part
  std::vector<Counterbore> counterbores; ///< the wider cylinders
  std::vector<Countersink> countersinks; ///< the cones
  std::optional<double> tip_angle;       ///< of the cone that ends in its apex, in degrees
};

std::vector<Hole> find_holes(const Part_faces& faces);

/// Three or more equal holes with parallel axes: the corners of a regular polygon, or the points of
/// a line or grid.
struct Hole_pattern
{
  std::vector<std::size_t> holes;
  std::optional<Point> center;       ///< of a circle
  double diameter = 0;               ///< of a circle
  std::size_t columns = 0, rows = 0; ///< of a grid
  double column_pitch = 0, row_pitch = 0;
};

std::vector<Hole_pattern> find_patterns(const Part_faces& faces, const std::vector<Hole>& holes);

} // namespace mesh_to_step

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_HOLES_H
