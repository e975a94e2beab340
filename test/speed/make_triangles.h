// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_SPEED_MAKE_TRIANGLES_H
#define CGAL_REGION_SEGMENTATION_TEST_SPEED_MAKE_TRIANGLES_H

#include "Triangles.h"

#include <cstddef>
#include <string>

namespace speed_benchmark {

/// Reads a file in the OFF format that holds triangles alone.
/// \throws std::runtime_error that names the file
Triangles read_triangles(const std::string& file);

/// Splits every triangle into four at the middles of its edges: the shape, and so the feature lines
/// and the first regions, stay the same. The four follow one another.
Triangles subdivided(const Triangles& coarse);

/// Moves every coordinate by up to `amplitude` times the mean length of an edge: creases
/// everywhere, and so many first regions. The same for the same input.
Triangles roughened(Triangles triangles, double amplitude);

/// The same with triangles and points in random order: neighbors far apart in memory. The same for
/// the same input.
Triangles shuffled(const Triangles& triangles);

/// A torus with waves on it, of about `number_of_faces` triangles (two for each of n * n quads).
Triangles wavy_torus(std::size_t number_of_faces);

} // namespace speed_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_SPEED_MAKE_TRIANGLES_H
