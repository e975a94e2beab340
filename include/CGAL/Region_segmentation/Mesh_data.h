// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_MESH_DATA_H
#define CGAL_REGION_SEGMENTATION_MESH_DATA_H

#include <cstdint>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationData
/// The set of data read from a mesh in addition to the normals and areas of faces and the lengths and angles of edges.
/// A part of a method that needs such data declares them in its static member `required_mesh_data`.
enum class Mesh_data : std::uint8_t {
  NOTHING_MORE = 0,
  POINTS = 1,      ///< the points of the vertices and the corners of the faces: `Flat_mesh::points()`
  CENTROIDS = 2,   ///< the means of the corners of the faces: `Flat_mesh::centroid()`
  SURFACE_AREA = 4, ///< the area of the surface, and lengths relative to it: `Flat_mesh::surface_area()`
  PATCHES = 14 ///< small flat patches of faces: `Flat_mesh::patches()`; with the centroids and the area of the surface
};

constexpr Mesh_data operator|(Mesh_data a, Mesh_data b)
{
  return Mesh_data(std::uint8_t(a) | std::uint8_t(b));
}

/// Whether the set `all` contains the set `some`.
constexpr bool includes(Mesh_data all, Mesh_data some)
{
  return (std::uint8_t(all) & std::uint8_t(some)) == std::uint8_t(some);
}

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_MESH_DATA_H
