// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_SUPERFACETS_MERGE_FEATURES_H
#define CGAL_REGION_SEGMENTATION_SUPERFACETS_MERGE_FEATURES_H

#include <CGAL/Region_segmentation/Graph/Region_shapes.h>
#include <CGAL/Region_segmentation/Superfacets/Visibility_merging.h>
#include <CGAL/Region_segmentation/Superfacets/Merge_model.h>
#include <CGAL/Region_segmentation/Support/Double_3.h>
#include <CGAL/Region_segmentation/Surface/Surface.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationGraph
/// Extends `Visibility_section_data` by the thickness beside the section, and by how much of it is
/// a deep valley or a contact of components. Filled by `Learned_annotator`. A model of
/// `SectionData`.
///
/// All data are sums over the adjacencies, in units of the square root of the area of the surface.
struct Learned_section_data : Visibility_section_data
{
  static constexpr double strongly_concave = 0.4; ///< deviation, in radians

  double strongly_concave_length = 0; ///< of concave edges with a deviation above
                                      ///< `strongly_concave`
  double link_length = 0;             ///< of links
  double log_thickness = 0;           ///< integral of the mean log thickness, averaged over the two
                                      ///< regions beside an edge from which merging starts

  /// Adds an adjacency of two faces to the section.
  void add_adjacency(const Surface& mesh, std::size_t a)
  {
    const double l = mesh.length(a) / mesh.length_unit(), deviation = signed_deviation(mesh, a);
    add(l, deviation);
    if (deviation > strongly_concave)
      strongly_concave_length += l;
    if (mesh.has_flag(a, Surface::LINK))
      link_length += l;
  }

  /// Adds another section between the same two regions.
  void absorb(const Learned_section_data& other)
  {
    Visibility_section_data::absorb(other);
    strongly_concave_length += other.strongly_concave_length;
    link_length += other.link_length;
    log_thickness += other.log_thickness;
  }
};

/// \ingroup PkgRegionSegmentationGraph
/// What kind of shape a whole surface is.
///
/// Sums are over the regions from which merging starts, or over their sections. A region has the
/// area a, the area vector V, and the centroid c relative to the centroid of the surface. A
/// quotient of 0 by 0 is 0.
struct Whole_shape
{
  double log_filling = 0;      ///< \f$\ln(1 / (\pi W^2))\f$, \f$W^2\f$ the trace of the covariance
                               ///< of the area: -0.45 for a disc
  double flatness = 0;         ///< \f$\sum |V| / \sum a\f$; in [0, 1], 1 where all are flat
  double strongly_concave = 0; ///< share of the length of the sections, see `Learned_section_data`
  double right_angles = 0;     ///< 1 minus the mean of \f$\sin^2 2 \alpha\f$ over all pairs of
                               ///< regions, by \f$|V|\f$, \f$\alpha\f$ the angle between their
                               ///< area vectors: 1 for a box, 7/15 for a sphere
  double outward = 0;          ///< \f$\sum V \cdot c / \sum |V| |c|\f$; in [-1, 1], 1 for a sphere
  double openness = 0;         ///< 1 minus the weight of the rays that hit: 0 for a closed surface,
                               ///< 1 for a flat sheet
};

/// \ingroup PkgRegionSegmentationGraph
/// Extends `Visibility_region_data` by how the thickness varies, what a region sees of itself, its
/// shape, and the shape of the surface. Filled by `Learned_annotator`. A model of `RegionData`.
///
/// Lengths are in units of the square root of the area of the surface.
struct Learned_region_data : Visibility_region_data
{
  double squared_log_thickness = 0; ///< integral over the area of the square of the mean log
                                    ///< thickness of the regions from which merging starts
  double own_visibility = 0;        ///< weight of the rays that start and end in the region
  double perimeter = 0;             ///< length of the sections with other regions
  Double_3 area_vector{0, 0, 0};    ///< integral of the normal
  Second_moments moments;           ///< of the area
  Whole_shape whole;                ///< the shape of the surface

  /// Adds the region on the other side of a section. All data are added, and `whole` remains. The
  /// visibility of the section is added to `own_visibility`, and twice its length is subtracted
  /// from `perimeter`.
  void absorb(const Learned_region_data& other, const Learned_section_data& between)
  {
    Visibility_region_data::absorb(other, between);
    squared_log_thickness += other.squared_log_thickness;
    own_visibility += other.own_visibility + between.visibility;
    perimeter += other.perimeter - 2 * between.length;
    area_vector = area_vector + other.area_vector;
    moments.add(other.moments);
  }
};

/// \ingroup PkgRegionSegmentationPolicies
/// The features of a section, its two regions and the whole surface from which the probability of a
/// merge is computed.
///
/// Of the two regions, m is the smaller and M the larger (of equal ones, m is the one of lower id),
/// and u is their union. The data of u are those of m and M merged across the section. All features
/// are invariant under motion, scaling and renumbering. Lengths are in units of the square root of
/// the area of the surface. Of a section, L is the length, C its `concave`, \f$s_{mM}\f$ its
/// `visibility` and \f$t_s\f$ its `log_thickness` by L. Of a region, a is the area, P the
/// perimeter, t the `log_thickness` by a, s the `visibility`, o the `own_visibility`, V the area
/// vector, z the centroid of its moments, w their covariance, \f$w_1 \geq w_2 \geq w_3\f$ its
/// eigenvalues, and \f$W = \sqrt{\mathrm{tr}\, w}\f$. Of moments with the sums \f$S_0, S_1, S_2\f$,
/// the centroid is \f$S_1 / S_0\f$ and the covariance \f$S_2 / S_0 - S_1 S_1^T / S_0^2\f$.
///
/// - 0 .. 3: the `Visibility_cost`; ln d, d its depth; C / L; the share of links in L;
/// - 4, 5: ln a of m, M;
/// - 6: \f$\ln(L^2 / a_M)\f$;
/// - 7 .. 9: \f$\ln(P^2 / a)\f$ of m, M, u;
/// - 10: \f$|t_m - t_M|\f$;
/// - 11, 12: t of m, M;
/// - 13, 14: \f$t_s - t\f$ of m, M;
/// - 15: \f$\sqrt{q / a - t^2}\f$ of u, q the `squared_log_thickness` (the standard deviation of
///   the log thickness);
/// - 16: \f$\ln L - \min(t_m, t_M)\f$;
/// - 17: \f$\ln W - t\f$ of M;
/// - 18, 19: \f$s_{mM} / \min(s_m, s_M)\f$; \f$s_{mM} / \max(s_m, s_M)\f$;
/// - 20, 21: 2 o / s of m, M (share of the rays that start and end in the region);
/// - 22, 23: \f$|V| / a\f$ of m, u (1 where it is flat);
/// - 24: \f$(V_m / |V_m| - V_M / |V_M|) \cdot (z_m - z_M) / |z_m - z_M|\f$ (below 0 where they face
///   each other);
/// - 25: \f$|z_m - z_M| / \sqrt{a_u}\f$;
/// - 26: \f$\sqrt{w_2 / w_1}\f$ of u (elongation);
/// - 27: \f$\sqrt{w_3 / w_2}\f$ of u (roundness);
/// - 28: \f$W_u / (W_m + W_M)\f$;
/// - 29, 30: \f$\ln(a / (\pi W^2))\f$ of m, M (-0.45 for a disc);
/// - 31 .. 36: the members of `Whole_shape`.
///
/// Conventions:
/// - A feature x is rounded to \f$\lfloor 512 x + 1/2 \rfloor\f$, an integer within [-32767,
///   32767], so that the last bits of sums and logarithms do not matter.
/// - A logarithm is that of at least \f$10^{-12}\f$; a quotient whose denominator is at most
///   \f$10^{-12}\f$ is 0; a negative number under a root counts as 0; areas of regions count as at
///   least \f$10^{-12}\f$, perimeters in logarithms as at least \f$10^{-6}\f$.
/// - Eigenvalues are computed by Viete's formula, with errors of up to \f$10^{-7}\f$ of the largest
///   one.
/// - A root of two eigenvalues, \f$\sqrt{a / b}\f$, is \f$\sqrt{(a + o) / (b + o)}\f$ with
///   \f$o = 10^{-6} e + 10^{-12}\f$, e the largest eigenvalue.
class Merge_features
{
public:
  using Values = Merge_model::Features;

  /// The places of the features that `Learned_cost` reads: the `Visibility_cost`, ln a_m, ln a_M.
  static constexpr std::size_t cost = 0, log_area_m = 4, log_area_l = 5;

  /// \tparam Graph a `Region_adjacency_graph` with the data of `Learned_annotator`
  template <typename Graph>
  static Values of(const Graph& graph, typename Graph::section_descriptor s)
  {
    auto m = graph.source(s), l = graph.target(s);
    if (std::make_pair(graph[l].area, l) < std::make_pair(graph[m].area, m))
      std::swap(m, l);
    Learned_region_data u = graph[m];
    u.absorb(graph[l], graph[s]);
    return rounded(of(Visibility_cost()(graph, s), graph[s], {graph[m]}, {graph[l]}, {u}));
  }

private:
  using Numbers = std::array<double, Merge_model::number_of_features>;

  static constexpr double smallest = 1e-12;

  static double log(double x) { return std::log((std::max)(x, smallest)); }

  static double root(double x) { return std::sqrt((std::max)(x, 0.0)); }

  static double ratio(double a, double b) { return b > smallest ? a / b : 0; }

  /// The square root of the quotient of two eigenvalues. Eigenvalues that are nearly 0 beside the
  /// largest one count as equal.
  static double root_of_ratio(double a, double b, double largest)
  {
    const double offset = 1e-6 * largest + smallest;
    return std::sqrt(((std::max)(a, 0.0) + offset) / ((std::max)(b, 0.0) + offset));
  }

  /// What features need to know of a region.
  struct Shape
  {
    const Learned_region_data& data;

    double area = (std::max)(data.area, smallest), log_area = log(area);
    double log_perimeter = 2 * log((std::max)(data.perimeter, 1e-6)) - log_area; ///< ln(P^2 / a)
    double t = data.mean_log_thickness();
    double own_visibility = ratio(2 * data.own_visibility, data.visibility);
    double normal_length = norm(data.area_vector), flatness = normal_length / area;
    Double_3 centroid = data.moments.centroid();
    Symmetric_3 covariance = data.moments.covariance();
    double width = root(covariance.trace());
    double log_filling = log_area - log(CGAL_PI * covariance.trace());
  };

  static Numbers of(double visibility_cost, const Learned_section_data& s, const Shape& m,
                    const Shape& l, const Shape& u)
  {
    const double log_length = log(s.length), t_s = ratio(s.log_thickness, s.length);
    const Double_3 line = m.centroid - l.centroid;
    const auto outward = [&](const Shape& shape) {
      return ratio(dot(shape.data.area_vector, line), shape.normal_length * norm(line));
    };
    const auto w = eigenvalues(u.covariance);
    const Whole_shape& whole = m.data.whole;
    return {// The section.
            visibility_cost, log(Visibility_cost().depth(s)), ratio(s.concave, s.length),
            ratio(s.link_length, s.length),
            // Sizes.
            m.log_area, l.log_area, 2 * log_length - l.log_area, m.log_perimeter, l.log_perimeter,
            u.log_perimeter,
            // Thickness.
            std::abs(m.t - l.t), m.t, l.t, t_s - m.t, t_s - l.t,
            root(ratio(u.data.squared_log_thickness, u.data.area) - u.t * u.t),
            log_length - (std::min)(m.t, l.t), log(l.width) - l.t,
            // Visibility.
            ratio(s.visibility, (std::min)(m.data.visibility, l.data.visibility)),
            ratio(s.visibility, (std::max)(m.data.visibility, l.data.visibility)), m.own_visibility,
            l.own_visibility,
            // The shape of the regions.
            m.flatness, u.flatness, outward(m) - outward(l), norm(line) / std::sqrt(u.area),
            root_of_ratio(w[1], w[0], w[0]), root_of_ratio(w[2], w[1], w[0]),
            ratio(u.width, m.width + l.width), m.log_filling, l.log_filling,
            // The whole surface.
            whole.log_filling, whole.flatness, whole.strongly_concave, whole.right_angles,
            whole.outward, whole.openness};
  }

  static Values rounded(const Numbers& x)
  {
    constexpr double bound = 32767, steps = 1 << Merge_model::feature_bits;
    Values result;
    for (std::size_t i = 0; i < x.size(); ++i)
      result[i] = std::int16_t(
        (std::max)(-bound, (std::min)(bound, std::floor(x[i] * steps + 0.5))));
    return result;
  }
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_SUPERFACETS_MERGE_FEATURES_H
