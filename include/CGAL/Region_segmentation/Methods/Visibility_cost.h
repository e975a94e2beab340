// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_VISIBILITY_COST_H
#define CGAL_REGION_SEGMENTATION_METHODS_VISIBILITY_COST_H

#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/concept_checks.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationGraph
/// Length, angles and visibility of a section, filled by `Visibility_annotator`. A model of
/// `SectionData`.
///
/// Lengths are in units of the square root of the area of the surface.
struct Visibility_section_data
{
  double length = 0;
  double concave = 0;    ///< integral of the deviation of concave edges, at most 0.6 rad each
  double convex = 0;     ///< integral of the deviation of convex edges, at most 2 rad each
  double bend = 0;       ///< integral of the angle between the mean normals of the first regions,
                         ///< positive where they face each other
  double visibility = 0; ///< weight of the rays between the two regions
  std::size_t number_of_adjacencies = 0; ///< 0: the regions see each other, but are not adjacent

  /// Accounts for a dual edge of the mesh. An edge of a degenerate face counts as flat.
  void add_adjacency(const Surface& surface, std::size_t adjacency)
  {
    add(surface.length(adjacency) / surface.length_unit(), signed_deviation(surface, adjacency));
  }

  /// Adds another section between the same two regions.
  void absorb(const Visibility_section_data& other)
  {
    length += other.length;
    concave += other.concave;
    convex += other.convex;
    bend += other.bend;
    visibility += other.visibility;
    number_of_adjacencies += other.number_of_adjacencies;
  }

protected:
  /// The deviation of an adjacency in radians: positive if it is concave, negative if it is convex.
  /// Where components touch there is a valley: a link counts as one of a right angle.
  static double signed_deviation(const Surface& surface, std::size_t adjacency)
  {
    return surface.has_flag(adjacency, Surface::LINK)      ? CGAL_PI / 2
           : surface.has_flag(adjacency, Surface::CONCAVE) ? surface.deviation(adjacency)
           : surface.has_flag(adjacency, Surface::CONVEX)  ? -surface.deviation(adjacency)
                                                           : 0;
  }

  /// Accounts for an edge by its length and signed deviation.
  void add(double l, double deviation)
  {
    length += l;
    ++number_of_adjacencies;
    if (deviation > 0)
      concave += l * (std::min)(deviation, 0.6);
    else
      convex += l * (std::min)(-deviation, 2.0);
  }
};

/// \ingroup PkgRegionSegmentationGraph
/// Area, thickness and visibility of a region, filled by `Visibility_annotator`. A model of
/// `RegionData`.
struct Visibility_region_data
{
  double area = 0;          ///< share of the area of the surface
  double log_thickness = 0; ///< integral over the area of the logarithm of the thickness
  double visibility = 0;    ///< weight of the ends of rays in the region

  double mean_log_thickness() const { return area > 0 ? log_thickness / area : 0; }

  void add_face(const Surface&, std::size_t /* face */) {}
  void add_border(const Surface&, std::size_t /* adjacency */) {}

  /// Adds the region on the other side of a section.
  void absorb(const Visibility_region_data& other, const Visibility_section_data& /* between */)
  {
    area += other.area;
    log_thickness += other.log_thickness;
    visibility += other.visibility;
  }
};

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

  /// \throws Invalid_method if a constant is not finite, or an offset not above 0
  void check_constants() const
  {
    for (double c : {depth_exponent, area_exponent, harmonic_share, length_exponent,
                     thickness_exponent, visibility_exponent, convex_weight, bend_weight})
      internal::check_constant("a constant of Visibility_cost", c, -internal::greatest_finite);
    for (double offset : {depth_offset, thickness_offset, visibility_offset})
      internal::check_constant("an offset of Visibility_cost", offset, internal::least_positive);
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
