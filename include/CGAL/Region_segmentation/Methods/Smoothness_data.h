// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_SMOOTHNESS_DATA_H
#define CGAL_REGION_SEGMENTATION_METHODS_SMOOTHNESS_DATA_H

#include <CGAL/Region_segmentation/Surface.h>

#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

class Smoothness_annotator;

/// \ingroup PkgRegionSegmentationGraph
/// Length of a section, and how far the surface is from smooth across it, filled by `Smoothness_annotator`. A model of
/// `SectionData`.
struct Smoothness_section_data
{
  double length = 0;               ///< in units of `Surface::unit()`
  double measured_length = 0;      ///< of the edges that are not beside a degenerate face, in these units
  double discontinuity = 0;        ///< integral along these; see `Smoothness_annotator`
  std::size_t number_of_edges = 0; ///< mesh edges

  /// \pre `measured_length` is not 0
  double mean_discontinuity() const { return discontinuity / measured_length; }

  void add_adjacency(const Surface& mesh, std::size_t edge)
  {
    length += mesh.length(edge);
    ++number_of_edges;
  }

  /// Adds another section between the same two regions.
  void absorb(const Smoothness_section_data& other)
  {
    length += other.length;
    measured_length += other.measured_length;
    discontinuity += other.discontinuity;
    number_of_edges += other.number_of_edges;
  }
};

/// \ingroup PkgRegionSegmentationGraph
/// Area and number of facets of a region. A model of `RegionData`.
struct Smoothness_region_data
{
  /// The annotator of the sections' data.
  using GraphAnnotator = Smoothness_annotator;

  double area = 0;   ///< of the faces that are not degenerate, in squared units of `Surface::unit()`
  double facets = 1; ///< first regions: plane pieces of the surface

  double mean_facet_area() const { return area / facets; }

  void add_face(const Surface& mesh, std::size_t face) { area += mesh.is_degenerate(face) ? 0 : mesh.area(face); }
  void add_border(const Surface&, std::size_t /* adjacency */) {}

  /// Adds the region on the other side of a section.
  void absorb(const Smoothness_region_data& other, const Smoothness_section_data& /* between */)
  {
    area += other.area;
    facets += other.facets;
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_SMOOTHNESS_DATA_H
