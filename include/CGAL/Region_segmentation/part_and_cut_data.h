// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_PART_AND_CUT_DATA_H
#define CGAL_REGION_SEGMENTATION_PART_AND_CUT_DATA_H

#include <CGAL/Region_segmentation/internal/Flat_mesh.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationGraph
/// What a section tells about the cut along it. A model of `SectionData`. Lengths are in units of the
/// mesh until `Sight` makes them relative to the square root of the area of the surface.
struct Cut_data
{
  double length = 0;
  double concave = 0;      ///< integral of the deviation of concave edges, at most 0.6 rad each
  double convex = 0;       ///< integral of the deviation of convex edges
  double bend = 0;         ///< integral of the angle between the mean normals of the first regions,
                           ///< positive where they face each other; made by `Sight`
  double sight = 0;        ///< rays between the two regions, by area; made by `Sight`
  std::size_t number_of_edges = 0; ///< 0: the regions only see each other

  /// Accounts for a dual edge of the mesh. An edge of a degenerate face counts as flat.
  void add_edge(const Flat_mesh& mesh, std::size_t lower_face, std::size_t edge)
  {
    const double l = mesh.length(edge);
    length += l;
    ++number_of_edges;
    if (mesh.has_flag(edge, Flat_mesh::CONCAVE))
      concave += l * (std::min)(mesh.deviation(lower_face, edge), 0.6);
    else if (mesh.has_flag(edge, Flat_mesh::CONVEX))
      convex += l * (std::min)(mesh.deviation(lower_face, edge), 2.0);
  }

  /// Takes in another section between the same two regions.
  void absorb(const Cut_data& other)
  {
    length += other.length;
    concave += other.concave;
    convex += other.convex;
    bend += other.bend;
    sight += other.sight;
    number_of_edges += other.number_of_edges;
  }
};

/// \ingroup PkgRegionSegmentationGraph
/// What a region tells about the part that it belongs to. A model of `RegionData`. The area is in
/// squared units of the mesh until `Sight` makes it a share of the area of the surface.
struct Part_data
{
  double area = 0;
  double thickness = 0; ///< integral over the area of the logarithm of the thickness; made by `Sight`
  double sight = 0;     ///< ends of rays in the region, by area; made by `Sight`

  double mean_thickness() const { return area > 0 ? thickness / area : 0; }

  void add_face(const Flat_mesh& mesh, std::size_t face) { area += mesh.area(face); }
  void add_border_edge(const Flat_mesh&, std::size_t /* lower_face */, std::size_t /* edge */) {}

  /// Takes in the region on the other side of a section.
  void absorb(const Part_data& other, const Cut_data& /* between */)
  {
    area += other.area;
    thickness += other.thickness;
    sight += other.sight;
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_PART_AND_CUT_DATA_H
