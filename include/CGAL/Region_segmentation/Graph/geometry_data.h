// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_GRAPH_GEOMETRY_DATA_H
#define CGAL_REGION_SEGMENTATION_GRAPH_GEOMETRY_DATA_H

#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <CGAL/number_type_config.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationGraph
/// Length and mean dihedral angle of a section. A model of `SectionData`.
///
/// A type that derives from it and has members of its own declares its own `add_adjacency()` and
/// `absorb()`, which call those of this class: inherited functions do not know the members.
struct Section_geometry
{
  double length = 0;                     ///< in units of `Surface::unit()`
  double link_length = 0;                ///< the length of the links of the section
  double sum_of_angles = 0;              ///< of the dihedral angle theta, in radians; pi for a link
  std::size_t number_of_adjacencies = 0; ///< edges, seams and links
  std::size_t number_of_links = 0;

  /// The plain mean of theta, in radians, in [0, pi].
  double mean_angle() const { return sum_of_angles / double(number_of_adjacencies); }
  /// Whether the two regions are adjacent across links alone.
  bool has_links_alone() const { return number_of_links == number_of_adjacencies; }

  /// Adds an adjacency of the surface. One without an angle counts with theta = pi.
  void add_adjacency(const Surface& surface, std::size_t adjacency)
  {
    const double l = surface.length(adjacency);
    length += l;
    sum_of_angles += CGAL_PI - surface.deviation(adjacency);
    ++number_of_adjacencies;
    if (surface.has_flag(adjacency, Surface::LINK)) {
      link_length += l;
      ++number_of_links;
    }
  }

  /// Adds another section between the same two regions.
  void absorb(const Section_geometry& other)
  {
    length += other.length;
    link_length += other.link_length;
    sum_of_angles += other.sum_of_angles;
    number_of_adjacencies += other.number_of_adjacencies;
    number_of_links += other.number_of_links;
  }
};

/// \ingroup PkgRegionSegmentationGraph
/// Area and perimeter of a region. A model of `RegionData`.
///
/// A type that derives from it and has members of its own declares its own `absorb()`, which calls
/// that of this class: the inherited function does not know the members. It also declares its own
/// `add_face()` and `add_border()`, unless an annotator sets the members.
struct Region_geometry
{
  double area = 0;      ///< in squared units of `Surface::unit()`
  double perimeter = 0; ///< length of the edges and seams shared with other regions, in units of
                        ///< `Surface::unit()`

  /// Adds a face of the region.
  void add_face(const Surface& surface, std::size_t face) { area += surface.area(face); }

  /// Adds an adjacency of the region and another one.
  void add_border(const Surface& surface, std::size_t adjacency)
  {
    if (!surface.has_flag(adjacency, Surface::LINK))
      perimeter += surface.length(adjacency);
  }

  /// Adds the region on the other side of the section `between`.
  template <typename SectionData>
  void absorb(const Region_geometry& other, const SectionData& between)
  {
    area += other.area;
    perimeter += other.perimeter - 2 * (between.length - between.link_length);
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_GRAPH_GEOMETRY_DATA_H
