// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_GEOMETRY_DATA_H
#define CGAL_REGION_SEGMENTATION_GRAPH_GEOMETRY_DATA_H

#include <CGAL/Region_segmentation/Flat_mesh.h>

#include <CGAL/number_type_config.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationGraph
/// Length and mean dihedral angle of a section. A model of `SectionData`.
///
/// User-defined data derives from it, or has the same member functions. A type that derives from it and has members of its
/// own declares its own `add_edge()` and `absorb()`, which call those of this class: inherited ones do not know the members,
/// and do not compile.
struct Section_geometry
{
  double length = 0;               ///< in units of `Flat_mesh::unit()`
  double sum_of_angles = 0;        ///< of the dihedral angle theta over the edges, in radians
  std::size_t number_of_edges = 0; ///< mesh edges

  /// The plain mean of theta over the edges, in radians, in [0, pi].
  double mean_angle() const { return sum_of_angles / double(number_of_edges); }

  /// Accounts for a dual edge of the mesh. An edge of a degenerate face counts with theta = pi.
  void add_edge(const Flat_mesh& mesh, std::size_t lower_face, std::size_t edge)
  {
    length += mesh.length(edge);
    sum_of_angles += CGAL_PI - mesh.deviation(lower_face, edge);
    ++number_of_edges;
  }

  /// Adds another section between the same two regions.
  void absorb(const Section_geometry& other)
  {
    length += other.length;
    sum_of_angles += other.sum_of_angles;
    number_of_edges += other.number_of_edges;
  }
};

/// \ingroup PkgRegionSegmentationGraph
/// Area and perimeter of a region. A model of `RegionData`.
///
/// A type that derives from it and has members of its own declares its own `absorb()`, which calls that of this class: the
/// inherited one would not merge the members, and does not compile. The same applies to the functions that sum them, unless
/// an annotator fills them.
struct Region_geometry
{
  double area = 0;      ///< in squared units of `Flat_mesh::unit()`
  double perimeter = 0; ///< length of the edges shared with other regions, in units of `Flat_mesh::unit()`

  /// Accounts for a face of the region.
  void add_face(const Flat_mesh& mesh, std::size_t face) { area += mesh.area(face); }

  /// Accounts for a dual edge between the region and another one.
  void add_border_edge(const Flat_mesh& mesh, std::size_t /* lower_face */, std::size_t edge)
  {
    perimeter += mesh.length(edge);
  }

  /// Adds the region on the other side of the section `between`.
  template <typename SectionData>
  void absorb(const Region_geometry& other, const SectionData& between)
  {
    area += other.area;
    perimeter += other.perimeter - 2 * between.length;
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_GEOMETRY_DATA_H
