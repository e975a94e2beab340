// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_VISIBILITY_DATA_H
#define CGAL_REGION_SEGMENTATION_METHODS_VISIBILITY_DATA_H

#include <CGAL/Region_segmentation/Flat_mesh.h>
#include <CGAL/Region_segmentation/internal/support/grid.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

class Visibility_annotator;

/// \ingroup PkgRegionSegmentationGraph
/// Length, angles and visibility of a section, filled by `Visibility_annotator`. A model of `SectionData`.
///
/// Lengths are in units of the square root of the area of the surface.
struct Visibility_section_data
{
  /// The annotator that fills these data.
  using GraphAnnotator = Visibility_annotator;
  static constexpr Mesh_data required_mesh_data = Mesh_data::SURFACE_AREA;

  double length = 0;
  double concave = 0;    ///< integral of the deviation of concave edges, at most 0.6 rad each
  double convex = 0;     ///< integral of the deviation of convex edges, at most 2 rad each
  double bend = 0;       ///< integral of the angle between the mean normals of the first regions,
                         ///< positive where they face each other
  double visibility = 0; ///< weight of the rays between the two regions
  std::size_t number_of_edges = 0; ///< 0: the regions see each other, but are not adjacent

  /// Accounts for a dual edge of the mesh. An edge of a degenerate face counts as flat.
  void add_edge(const Flat_mesh& mesh, std::size_t lower_face, std::size_t edge)
  {
    add(mesh.length(edge) / mesh.relative_unit(), signed_deviation(mesh, lower_face, edge));
  }

  /// Adds another section between the same two regions.
  void absorb(const Visibility_section_data& other)
  {
    length += other.length;
    concave += other.concave;
    convex += other.convex;
    bend += other.bend;
    visibility += other.visibility;
    number_of_edges += other.number_of_edges;
  }

protected:
  /// The deviation of a dual edge in radians: positive if it is concave, negative if it is convex.
  static double signed_deviation(const Flat_mesh& mesh, std::size_t lower_face, std::size_t edge)
  {
    // Of coplanar faces the sign is rounding, and the arc cosine enlarges it.
    const double deviation = internal::on_grid(mesh.deviation(lower_face, edge));
    return mesh.has_flag(edge, Flat_mesh::CONCAVE) ? deviation : mesh.has_flag(edge, Flat_mesh::CONVEX) ? -deviation : 0;
  }

  /// Accounts for an edge by its length and signed deviation.
  void add(double l, double deviation)
  {
    length += l;
    ++number_of_edges;
    if (deviation > 0)
      concave += l * (std::min)(deviation, 0.6);
    else
      convex += l * (std::min)(-deviation, 2.0);
  }
};

/// \ingroup PkgRegionSegmentationGraph
/// Area, thickness and visibility of a region, filled by `Visibility_annotator`. A model of `RegionData`.
struct Visibility_region_data
{
  /// The annotator that fills these data.
  using GraphAnnotator = Visibility_annotator;

  double area = 0;          ///< share of the area of the surface
  double log_thickness = 0; ///< integral over the area of the logarithm of the thickness
  double visibility = 0;    ///< weight of the ends of rays in the region

  double mean_log_thickness() const { return area > 0 ? log_thickness / area : 0; }

  void add_face(const Flat_mesh&, std::size_t /* face */) {}
  void add_border_edge(const Flat_mesh&, std::size_t /* lower_face */, std::size_t /* edge */) {}

  /// Adds the region on the other side of a section.
  void absorb(const Visibility_region_data& other, const Visibility_section_data& /* between */)
  {
    area += other.area;
    log_thickness += other.log_thickness;
    visibility += other.visibility;
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_VISIBILITY_DATA_H
