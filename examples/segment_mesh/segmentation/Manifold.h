// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MANIFOLD_H
#define CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MANIFOLD_H

#include "soup/Polygon_soup.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace segment_mesh {

/// A soup as an oriented 2-manifold, for what is described by borders and volumes. Faces whose
/// corners are not different are left out, the others are turned, and torn where more than two
/// meet.
struct Manifold
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

  Mesh mesh;
  std::vector<std::size_t> face_of_mesh_face;   ///< of the soup
  std::vector<std::size_t> point_of_mesh_point; ///< of the soup

  /// The values of faces of the soup for those of the mesh.
  template <typename Value>
  std::vector<Value> values_of_mesh_faces(const std::vector<Value>& values) const
  {
    std::vector<Value> result;
    result.reserve(face_of_mesh_face.size());
    for (std::size_t f : face_of_mesh_face)
      result.push_back(values[f]);
    return result;
  }
};

/// The values of the faces of a mesh as a property map.
template <typename Values>
auto face_map(const Manifold::Mesh& mesh, Values& values)
{
  return boost::make_iterator_property_map(values.begin(), get(boost::face_index, mesh));
}

Manifold make_manifold(const Polygon_soup& soup);

} // namespace segment_mesh

#endif // CGAL_REGION_SEGMENTATION_SEGMENT_MESH_MANIFOLD_H
