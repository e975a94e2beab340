// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_VOLUMES_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_VOLUMES_H

#include <CGAL/Region_segmentation/internal/segments/Mesh_geometry.h>
#include <CGAL/Region_segmentation/internal/segments/Segmented_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// For each vertex on a border, the mean of the vertices of its network of border edges.
inline std::vector<Double_3> apices_of_caps(const Segmented_halfedges& mesh,
                                            const Mesh_geometry& geometry)
{
  using Index = Halfedge_table::Index;
  Lowest_root_forest networks(mesh.number_of_vertices);
  std::vector<char> is_on_border(mesh.number_of_vertices, false);
  for (Index h = 0; h < mesh.size(); ++h)
    if (mesh.is_on_border(h)) {
      networks.unite(mesh.source[h], mesh.target(h));
      is_on_border[mesh.source[h]] = is_on_border[mesh.target(h)] = true;
    }
  std::vector<Double_3> apices(mesh.number_of_vertices, Double_3{0, 0, 0});
  std::vector<std::size_t> sizes(mesh.number_of_vertices, 0);
  for (Index v = 0; v < mesh.number_of_vertices; ++v)
    if (is_on_border[v]) {
      Double_3& sum = apices[networks.root(v)];
      sum = sum + geometry.point(v);
      ++sizes[networks.root(v)];
    }
  for (Index v = 0; v < mesh.number_of_vertices; ++v)
    if (is_on_border[v]) {
      const Index root = networks.root(v); // not above v
      apices[v] = root == v ? 1 / double(sizes[v]) * apices[v] : apices[root];
    }
  return apices;
}

/// The volume of each segment with its caps, and at the end that of the faces without a segment;
/// see `Segment_description::volume`. They add up to the volume of the mesh.
///
/// By the divergence theorem, as the sum of the tetrahedra from a point of the segment to its faces
/// and to the triangles of its caps.
inline std::vector<double> segment_volumes(const Segmented_halfedges& mesh,
                                           const Mesh_geometry& geometry)
{
  using Index = Halfedge_table::Index;
  const std::size_t number = mesh.number_of_segments;
  const std::vector<Double_3> apices = apices_of_caps(mesh, geometry);
  std::vector<double> volumes(number + 1, 0);
  std::vector<Index> origins(number + 1, Halfedge_table::none); // vertices
  for (Index f = 0; f < mesh.number_of_faces(); ++f) {
    const std::size_t segment = mesh.segment_of_face[f] == mesh.none ? number
                                                                     : mesh.segment_of_face[f];
    if (origins[segment] == mesh.none)
      origins[segment] = mesh.source[mesh.first[f]];
    const Double_3 origin = geometry.point(origins[segment]);
    const Double_3 corner = geometry.point(mesh.source[mesh.first[f]]) - origin;
    volumes[segment] += dot(corner, geometry.area_vector(f)) / 3;
    for (Index h = mesh.first[f]; h < mesh.first[f + 1]; ++h)
      if (mesh.is_on_border(h)) {
        const Double_3 apex = apices[mesh.source[h]] - origin;
        const Double_3 from = geometry.point(mesh.target(h)) - origin,
                       to = geometry.point(mesh.source[h]) - origin;
        volumes[segment] += geometry.orientation(f) * dot(apex, cross(from, to)) / 6;
      }
  }
  return volumes;
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SEGMENTS_SEGMENT_VOLUMES_H
