// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_SMOOTHNESS_COST_H
#define CGAL_REGION_SEGMENTATION_METHODS_SMOOTHNESS_COST_H

#include <CGAL/Region_segmentation/Methods/Smoothness_data.h>

#include <algorithm>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// The mean discontinuity of the surface along a section. A model of `SectionCost`, for graphs annotated by
/// `Smoothness_annotator`.
///
/// The mean of a few edges is uncertain, so crumbs would remain where triangles are irregular: between regions whose
/// facets have similar areas it is multiplied by \f$n / (n + n_0)\f$, \f$n\f$ the smaller number of facets, unless it
/// is that of a crease. The facets of fillets and planes are not similar.
///
/// A section of which nothing was measured, since all of its edges are beside degenerate faces, costs nothing. A region of
/// degenerate faces alone joins a neighbor before all other merges, across the longest section first.
struct Smoothness_cost
{
  using RegionData = Smoothness_region_data;
  using SectionData = Smoothness_section_data;

  double crumb_facets = 4;  ///< n_0, at least 0
  double similar_areas = 3; ///< the ratio of mean areas from which facets are not similar, at least 1
  double crease = 2;        ///< the least mean discontinuity of a crease

  template <typename Graph>
  double operator()(const Graph& graph, typename Graph::section_descriptor s) const
  {
    const Smoothness_region_data &a = graph[graph.source(s)], &b = graph[graph.target(s)];
    if (!(graph[s].measured_length > 0))
      return a.area > 0 && b.area > 0 ? 0 : -graph[s].length;
    const double mean = graph[s].mean_discontinuity();
    const double areas[] = {a.mean_facet_area(), b.mean_facet_area()};
    const bool is_similar =
      areas[0] < similar_areas * areas[1] && areas[1] < similar_areas * areas[0] && mean < crease;
    const double facets = (std::min)(a.facets, b.facets);
    return is_similar ? mean * facets / (facets + crumb_facets) : mean;
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_SMOOTHNESS_COST_H
