// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_VISIBILITY_COST_H
#define CGAL_REGION_SEGMENTATION_METHODS_VISIBILITY_COST_H

#include <CGAL/Region_segmentation/Methods/Visibility_data.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// The strength of the separation of two regions by a section: the logarithm of a product of
/// powers. A model of `SectionCost`, for graphs annotated by `Visibility_annotator`.
///
/// A section of length \f$L\f$ between regions of areas \f$a_i, a_j\f$, \f$m\f$ the smaller and
/// \f$h\f$ their harmonic mean (all relative, see `Visibility_annotator`), costs \f[ p_d \ln d +
/// p_a ((1 - \eta) \ln m + \eta \ln h) - p_l \ln \frac{L^2}{m}
///    + p_t \ln (t_0 + |t_i - t_j|) - p_s \ln \left(s_0 + \frac{s_{ij}}{\min(s_i, s_j)}\right), \f]
/// \f$d = \max(0, (C - w_x X + w_b B) / L) + d_0\f$: the depth of the valley along the section,
/// from the integrals of concave and convex deviations \f$C, X\f$ and of the bend \f$B\f$; \f$t\f$
/// the mean thickness of a region; \f$s_{ij}\f$ the rays between the regions and \f$s_i\f$ those
/// that end in one. It has no unit.
///
/// The constants were chosen on half of the Princeton benchmark, see `doc/accuracy.md`.
struct Visibility_cost
{
  using RegionData = Visibility_region_data;
  using SectionData = Visibility_section_data;

  double depth_exponent = 4;          ///< p_d
  double depth_offset = 0.022;        ///< d_0, radian
  double area_exponent = 1.74;        ///< p_a
  double harmonic_share = 0.16;       ///< eta
  double length_exponent = 0.95;      ///< p_l
  double thickness_exponent = 1;      ///< p_t: 1 sets the scale of the cost
  double thickness_offset = 0.18;     ///< t_0
  double visibility_exponent = 0.195; ///< p_s
  double visibility_offset = 0.01;    ///< s_0
  double convex_weight = 0.3;         ///< w_x
  double bend_weight = 0.08;          ///< w_b

  /// The constants while regions are many and small: regions that see each other belong together,
  /// and depth and area count less.
  static Visibility_cost for_many_regions()
  {
    Visibility_cost cost;
    cost.depth_exponent = 3.14;
    cost.depth_offset = 0.055;
    cost.area_exponent = 1.2;
    cost.length_exponent = 0.87;
    cost.visibility_exponent = 0.49;
    return cost;
  }

  /// d, the depth of the valley along a section, in radians.
  double depth(const Visibility_section_data& section) const
  {
    const double length = (std::max)(section.length, smallest);
    return (std::max)(
             0.0, (section.concave - convex_weight * section.convex + bend_weight * section.bend) /
                    length) +
           depth_offset;
  }

  template <typename Graph>
  double operator()(const Graph& graph, typename Graph::section_descriptor s) const
  {
    const Visibility_section_data& section = graph[s];
    const Visibility_region_data &a = graph[graph.source(s)], &b = graph[graph.target(s)];
    const double length = (std::max)(section.length, smallest);
    const double smaller = (std::max)((std::min)(a.area, b.area), smallest);
    const double larger = (std::max)((std::max)(a.area, b.area), smallest);
    const double harmonic = 2 * smaller * larger / (smaller + larger);
    const double seen = (std::min)(a.visibility, b.visibility);
    const double mutual = seen > 0 ? section.visibility / seen : 0;
    const double log_smaller = std::log(smaller);
    return depth_exponent * std::log(depth(section)) +
           area_exponent *
             ((1 - harmonic_share) * log_smaller + harmonic_share * std::log(harmonic)) -
           length_exponent * (2 * std::log(length) - log_smaller) +
           thickness_exponent * std::log(thickness_offset + std::abs(a.mean_log_thickness() -
                                                                     b.mean_log_thickness())) -
           visibility_exponent * std::log(visibility_offset + mutual);
  }

private:
  static constexpr double smallest = 1e-12; // relative lengths and areas below it count as this one
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_VISIBILITY_COST_H
