// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MANIFOLD_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MANIFOLD_H

#include "segmentation/make_manifold.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

namespace segment_mesh {

struct Manifold : Manifold_of<CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>>
{};

/// The values of the faces of a mesh as a property map.
template <typename Values>
auto face_map(const Manifold::Mesh& mesh, Values& values)
{
  return boost::make_iterator_property_map(values.begin(), get(boost::face_index, mesh));
}

Manifold make_manifold(const Polygon_soup& soup);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MANIFOLD_H
