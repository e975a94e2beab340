// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_EXAMPLES_PART_MESH_H
#define CGAL_REGION_SEGMENTATION_EXAMPLES_PART_MESH_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Region_segmentation/Part_faces/Fitted_surface.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <vector>

namespace mesh_to_step {

namespace RS = CGAL::Region_segmentation;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Labels = Mesh::Property_map<Mesh::Face_index, std::size_t>;
using Fitted_surface = RS::Fitted_surface<Kernel>;
using Part_faces = std::vector<RS::Part_face<Kernel>>;

} // namespace mesh_to_step

#endif // CGAL_REGION_SEGMENTATION_EXAMPLES_PART_MESH_H
