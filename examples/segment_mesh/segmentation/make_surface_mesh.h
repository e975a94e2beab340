// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MAKE_SURFACE_MESH_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MAKE_SURFACE_MESH_H

#include "soup/Polygon_soup.h"
#include "soup/link_corners.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

namespace segment_mesh {

using Surface_mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

/// The mesh of a soup, whose faces and vertices have the indices that they have there.
///
/// \cgal's `polygon_soup_to_polygon_mesh()`, which keeps the mesh valid after every face, takes 2.1 to 2.7 times as long
/// (1 and 10 million triangles), longer than segmenting by two-step.
/// \pre `links` are those of the soup, which has no isolated points
Surface_mesh make_surface_mesh(const Polygon_soup& soup, const Corner_links& links);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MAKE_SURFACE_MESH_H
