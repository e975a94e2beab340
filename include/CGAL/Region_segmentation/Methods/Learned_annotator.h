// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_LEARNED_ANNOTATOR_H
#define CGAL_REGION_SEGMENTATION_METHODS_LEARNED_ANNOTATOR_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/Methods/Learned_data.h>
#include <CGAL/Region_segmentation/Methods/Visibility_annotator.h>
#include <CGAL/Region_segmentation/Methods/Whole_shape.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/internal/regions/Region_shapes.h>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationAnnotators
/// fills, in addition to `Visibility_annotator`, the data of which `Merge_features` are made:
/// for graphs with `Learned_region_data` and `Learned_section_data`.
///
/// A face of area \f$a\f$ (share of the surface), unit normal \f$N\f$ and centroid \f$c\f$ adds to
/// its region
/// - \f$a N\f$ to the area vector, and
/// - \f$a\f$, \f$a c\f$ and \f$a (c c^T + \sigma a (I - N N^T))\f$ to the moments, \f$\sigma = 1 /
/// (6 \sqrt{3})\f$: those
///   of an equilateral triangle of its area.
///
/// The perimeter is the sum of the lengths of the region's sections; borders of the mesh do not
/// count. The own visibility is the weight of the rays that start and end in the region. The log
/// thickness of a section is its length times the mean of the thicknesses of its two regions.
/// Coordinates are relative to the centroid of the first face, in units of \f$\sqrt{A}\f$. Each
/// region has the `Whole_shape` of all of them.
///
/// Complexity: that of `Visibility_annotator`, and O(F + S). Deterministic.
class Learned_annotator : public Visibility_annotator
{
  using Index = Surface::Index;

public:
  using RegionData = Learned_region_data;
  using SectionData = Learned_section_data;

  /// `rays`: of the regions
  template <typename Graph>
  void operator()(Graph& graph, const Surface& surface, const Partition& regions,
                  const Region_rays& rays) const
  {
    Visibility_annotator::operator()(graph, surface, regions, rays);
    if (surface.area() == 0)
      return;
    set_shapes(graph, rays.shapes());
    set_thickness_and_visibility(graph);
    const Whole_shape whole = internal::whole_shape(graph);
    for (auto range = vertices(graph); range.first != range.second; ++range.first)
      graph[*range.first].whole = whole;
  }

private:
  template <typename Graph>
  static void set_shapes(Graph& graph, const internal::Region_shapes& shapes)
  {
    for (Index r = 0; r < shapes.regions.size(); ++r) {
      graph[r].area_vector = shapes.regions[r].area_vector;
      graph[r].moments = shapes.regions[r].moments;
    }
  }

  template <typename Graph>
  static void set_thickness_and_visibility(Graph& graph)
  {
    for (auto range = vertices(graph); range.first != range.second; ++range.first) {
      Learned_region_data& region = graph[*range.first];
      region.squared_log_thickness = region.log_thickness * region.mean_log_thickness();
      region.own_visibility = region.visibility / 2;
      region.perimeter = 0;
    }
    for (auto range = edges(graph); range.first != range.second; ++range.first) {
      Learned_section_data& section = graph[*range.first];
      Learned_region_data &a = graph[graph.source(*range.first)],
                          &b = graph[graph.target(*range.first)];
      section.log_thickness = section.length * (a.mean_log_thickness() + b.mean_log_thickness()) /
                              2;
      for (Learned_region_data* region : {&a, &b}) {
        region->own_visibility -= section.visibility / 2;
        region->perimeter += section.length;
      }
    }
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_LEARNED_ANNOTATOR_H
