// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_SHAPES_H
#define CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_SHAPES_H

#include "Triangles.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <string>

namespace speed_benchmark {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// \throws std::runtime_error if the triangles are no manifold
Surface_mesh make_surface_mesh(const Triangles& triangles);

/// A shape of about so many faces: `smooth`, a real mesh, every triangle split into four until
/// there are enough; `noisy`, the same with every vertex moved; `shuffled`, the smooth one with
/// faces and vertices in random order; `loop`, the real mesh subdivided by Loop's scheme; `torus`,
/// made here. `folder`: where the `.off` files of CGAL's demos are, in whatever depth
/// \throws std::runtime_error if a file is missing
Triangles make_shape(const std::string& shape, std::size_t faces, const std::string& folder);

} // namespace speed_benchmark

#endif // CGAL_REGION_SEGMENTATION_TEST_TOOLS_BENCHMARK_SHAPES_H
