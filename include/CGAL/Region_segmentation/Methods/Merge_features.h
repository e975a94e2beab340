// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_MERGE_FEATURES_H
#define CGAL_REGION_SEGMENTATION_METHODS_MERGE_FEATURES_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Methods/Learned_data.h>
#include <CGAL/Region_segmentation/Methods/Visibility_cost.h>
#include <CGAL/Region_segmentation/Methods/Whole_shape.h>
#include <CGAL/Region_segmentation/internal/model/Merge_model.h>
#include <CGAL/Region_segmentation/internal/support/Second_moments.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationPolicies
/// The features of a section, its two regions and the whole surface from which the probability of a
/// merge is computed.
///
/// Of the two regions, m is the smaller and M the larger (of equal ones, m is the one of lower id),
/// u is their union. The data of u are those of m and M merged across the section. All features are
/// invariant under motion, scaling and renumbering. Lengths are in units of the square root of the
/// area of the surface. Of a section, L is the length, C, X and B are its `concave`, `convex` and
/// `bend`, \f$s_{mM}\f$ its `visibility`, \f$t_s\f$ its `log_thickness` by L, and c the covariance
/// of its moments, \f$c_1 \geq c_2 \geq c_3\f$ its eigenvalues. Of a region, a is the area, P the
/// perimeter, t the `log_thickness` by a, s the `visibility`, V the area vector, \f$c_m\f$ (of m)
/// the centroid of its moments, w their covariance, \f$w_1 \geq w_2 \geq w_3\f$ its eigenvalues,
/// and \f$W = \sqrt{\mathrm{tr}\, w}\f$. Of moments with the sums \f$S_0, S_1, S_2\f$, the centroid
/// is \f$S_1 / S_0\f$ and the covariance \f$S_2 / S_0 - S_1 S_1^T / S_0^2\f$. The standard
/// deviation of the log thickness is \f$\sqrt{q / a - t^2}\f$, q the `squared_log_thickness`. The
/// model reads the features in the order in which they are listed. Conventions:
/// - A feature x is rounded to \f$\lfloor 512 x + 1/2 \rfloor\f$, an integer within [-32767,
/// 32767], so that the last
///   bits of sums and logarithms do not matter.
/// - A logarithm is that of at least \f$10^{-12}\f$; a quotient whose denominator is at most
/// \f$10^{-12}\f$ is 0; a
///   negative number under a root counts as 0; areas of regions count as at least \f$10^{-12}\f$
///   except in ln a_m, ln P and ln L, where the logarithm does this.
/// - Eigenvalues are computed by Viete's formula, with errors of up to \f$10^{-7}\f$ of the largest
/// one.
/// - A root of two eigenvalues, \f$\sqrt{a / b}\f$, is \f$\sqrt{(a + o) / (b + o)}\f$ with
///   \f$o = 10^{-6} e + 10^{-12}\f$, e the largest eigenvalue.
/// - The perimeter of u is at least \f$10^{-6}\f$ in its logarithm.
class Merge_features
{
public:
  enum Feature : std::size_t {
    // The section: L its length
    COST,              ///< `Visibility_cost`
    LOG_DEPTH,         ///< ln d, the depth of `Visibility_cost`
    CONCAVE,           ///< C / L, see `Visibility_section_data`
    CONVEX,            ///< X / L
    BEND,              ///< B / L
    WEAKLY_CONCAVE,    ///< share of the length, see `Learned_section_data`; in [0, 1]
    STRONGLY_CONCAVE,  ///< share of the length; in [0, 1]
    STRONGLY_CONVEX,   ///< share of the length; in [0, 1]
    SQUARED_DEVIATION, ///< mean of the signed square of the deviation; in [-pi^2, pi^2]
    // The shape of the section: c the covariance of its points, c1 >= c2 >= c3 its eigenvalues
    CLOSEDNESS,       ///< ln(L^2 / (4 pi^2 tr c)): 0 for a circle, -1.19 for a segment
    SECTION_WIDTH,    ///< sqrt(c2 / c1); in [0, 1]
    SECTION_DEPTH,    ///< sqrt(c3 / c1); in [0, 1]
    LOG_SECTION_AREA, ///< ln(2 pi sqrt(c1 c2 + c1 c3 + c2 c3) / a_m + 10^-4): the area of an
                      ///< ellipse
    // Sizes: a the area, P the perimeter
    LOG_AREA_M,        ///< ln a_m
    LOG_AREA_L,        ///< ln a_M
    LOG_AREA_U,        ///< ln a_u
    LOG_LENGTH_M,      ///< ln(L^2 / a_m)
    LOG_LENGTH_L,      ///< ln(L^2 / a_M)
    PERIMETER_SHARE_M, ///< L / P_m; in [0, 1]
    PERIMETER_SHARE_L, ///< L / P_M; in [0, 1]
    LOG_PERIMETER_M,   ///< ln(P_m^2 / a_m)
    LOG_PERIMETER_L,   ///< ln(P_M^2 / a_M)
    LOG_PERIMETER_U,   ///< ln(P_u^2 / a_u)
    // Thickness: t the mean log thickness of a region, t_s that along the section
    THICKNESS_STEP,        ///< |t_m - t_M|
    THICKNESS_DIFFERENCE,  ///< t_m - t_M
    THICKNESS_M,           ///< t_m
    THICKNESS_L,           ///< t_M
    SECTION_THICKNESS_M,   ///< t_s - t_m
    SECTION_THICKNESS_L,   ///< t_s - t_M
    THICKNESS_DEVIATION_M, ///< standard deviation of the log thickness of the first regions of m
    THICKNESS_DEVIATION_L, ///< the same of M
    THICKNESS_DEVIATION_U, ///< the same of u
    LENGTH_FOR_THICKNESS,  ///< ln L - min(t_m, t_M)
    WIDTH_FOR_THICKNESS_M, ///< ln W_m - t_m
    WIDTH_FOR_THICKNESS_L, ///< ln W_M - t_M
    // Visibility: s the weight of the rays that end in a region, s_mM of those between the two; all
    // in [0, 1]
    VISIBILITY_M,     ///< s_mM / min(s_m, s_M)
    VISIBILITY_L,     ///< s_mM / max(s_m, s_M)
    OWN_VISIBILITY_M, ///< share of s_m by rays that start and end in m
    OWN_VISIBILITY_L, ///< the same of M
    OWN_VISIBILITY_U, ///< the same of u
    // Shape: V the area vector; w1 >= w2 >= w3 the eigenvalues of the covariance of the area, W^2
    // their sum
    FLATNESS_M, ///< |V_m| / a_m; in [0, 1], 1 where it is flat
    FLATNESS_L, ///< |V_M| / a_M
    FLATNESS_U, ///< |V_u| / a_u
    NORMALS,    ///< cosine between V_m and V_M; in [-1, 1]
    OUTWARD,  ///< (V_m / |V_m| - V_M / |V_M|) . (c_m - c_M) / |c_m - c_M|: below 0 where they face
              ///< each other
    DISTANCE, ///< |c_m - c_M| / sqrt(a_u), c the centroids
    ELONGATION_M,  ///< sqrt(w2 / w1) of m; in [0, 1]
    ELONGATION_L,  ///< of M
    ELONGATION_U,  ///< of u
    ROUNDNESS_M,   ///< sqrt(w3 / w2) of m; in [0, 1]
    ROUNDNESS_L,   ///< of M
    ROUNDNESS_U,   ///< of u
    ALIGNMENT,     ///< tr(w_m w_M) / (tr w_m tr w_M); in [0, 1]
    SECTION_ALONG, ///< share of the variance of the section along the line of the centroids; in [0,
                   ///< 1]
    WIDTH_OF_BOTH, ///< W_u / (W_m + W_M)
    WIDTH_OF_LARGER, ///< W_u / W_M
    LOG_FILLING_M,   ///< ln(a_m / (pi W_m^2)): -0.45 for a disc
    LOG_FILLING_L,   ///< of M
    LOG_FILLING_U,   ///< of u
    // The whole surface, the same for all sections
    WHOLE_LOG_FILLING,      ///< `Whole_shape::log_filling`
    WHOLE_FLATNESS,         ///< `Whole_shape::flatness`
    WHOLE_STRONGLY_CONCAVE, ///< `Whole_shape::strongly_concave`
    WHOLE_RIGHT_ANGLES,     ///< `Whole_shape::right_angles`
    WHOLE_OUTWARD,          ///< `Whole_shape::outward`
    NUMBER_OF_FEATURES
  };

  using Model = internal::Merge_model<NUMBER_OF_FEATURES>;
  using Values = Model::Features;

  /// \tparam Graph a `Region_adjacency_graph` with the data of `Learned_annotator`
  template <typename Graph>
  static Values of(const Graph& graph, typename Graph::section_descriptor s)
  {
    auto m = graph.source(s), l = graph.target(s);
    if (graph[l].area < graph[m].area || (graph[l].area == graph[m].area && l < m))
      std::swap(m, l);
    Merge_features features(graph[m], graph[l], graph[s]);
    features.set(COST, Visibility_cost()(graph, s));
    return features.rounded();
  }

private:
  /// A region, and what several features need of it.
  struct Shape
  {
    double area, thickness, own_visibility, normal_length, width;
    Double_3 area_vector, centroid;
    internal::Symmetric_3 covariance;

    explicit Shape(const Learned_region_data& region)
      : area((std::max)(region.area, smallest))
      , thickness(region.mean_log_thickness())
      , own_visibility(ratio(2 * region.own_visibility, region.visibility))
      , normal_length(norm(region.area_vector))
      , area_vector(region.area_vector)
      , centroid(region.moments.centroid())
      , covariance(region.moments.covariance())
    {
      width = std::sqrt((std::max)(0.0, covariance.trace()));
    }
  };

  Merge_features(const Learned_region_data& m, const Learned_region_data& l,
                 const Learned_section_data& section)
  {
    Learned_region_data u = m;
    u.absorb(l, section);
    const Shape shape_m(m), shape_l(l), shape_u(u);
    set_section(section);
    set_shape_of_section(section, shape_m, shape_l);
    set_sizes(section, m, l, u);
    set_thickness(section, m, l, u);
    set_widths(section, shape_m, shape_l, shape_u);
    set_visibility(section, m, l);
    set_regions({&shape_m, &shape_l, &shape_u});
    set_pair(shape_m, shape_l, shape_u);
    set_whole(m.whole);
  }

  void set_section(const Learned_section_data& section)
  {
    const Visibility_cost cost;
    set(LOG_DEPTH, log(cost.depth(section)));
    set(CONCAVE, ratio(section.concave, section.length));
    set(CONVEX, ratio(section.convex, section.length));
    set(BEND, ratio(section.bend, section.length));
    set(WEAKLY_CONCAVE, ratio(section.weakly_concave_length, section.length));
    set(STRONGLY_CONCAVE, ratio(section.strongly_concave_length, section.length));
    set(STRONGLY_CONVEX, ratio(section.strongly_convex_length, section.length));
    set(SQUARED_DEVIATION, ratio(section.squared_deviation, section.length));
  }

  void set_shape_of_section(const Learned_section_data& section, const Shape& m, const Shape& l)
  {
    const internal::Symmetric_3 covariance = section.moments.covariance();
    const auto c = internal::eigenvalues(covariance);
    set(CLOSEDNESS,
        log(section.length * section.length) - log(4 * CGAL_PI * CGAL_PI * covariance.trace()));
    set(SECTION_WIDTH, root_of_ratio(c[1], c[0], c[0]));
    set(SECTION_DEPTH, root_of_ratio(c[2], c[0], c[0]));
    const double squared_area = 4 * CGAL_PI * CGAL_PI *
                                (std::max)(0.0, covariance.second_invariant());
    set(LOG_SECTION_AREA, std::log(std::sqrt(squared_area) / m.area + 1e-4));
    const Double_3 line = l.centroid - m.centroid;
    set(SECTION_ALONG, ratio(covariance.along(line), covariance.trace() * squared_norm(line)));
  }

  void set_sizes(const Learned_section_data& section, const Learned_region_data& m,
                 const Learned_region_data& l, const Learned_region_data& u)
  {
    const double length = 2 * log(section.length);
    set(LOG_AREA_M, log(m.area));
    set(LOG_AREA_L, log(l.area));
    set(LOG_AREA_U, log(u.area));
    set(LOG_LENGTH_M, length - log(m.area));
    set(LOG_LENGTH_L, length - log(l.area));
    set(PERIMETER_SHARE_M, ratio(section.length, m.perimeter));
    set(PERIMETER_SHARE_L, ratio(section.length, l.perimeter));
    set(LOG_PERIMETER_M, 2 * log(m.perimeter) - log(m.area));
    set(LOG_PERIMETER_L, 2 * log(l.perimeter) - log(l.area));
    set(LOG_PERIMETER_U, 2 * log((std::max)(u.perimeter, least_perimeter)) - log(u.area));
  }

  void set_thickness(const Learned_section_data& section, const Learned_region_data& m,
                     const Learned_region_data& l, const Learned_region_data& u)
  {
    const double t_m = m.mean_log_thickness(), t_l = l.mean_log_thickness();
    const double t_s = ratio(section.log_thickness, section.length);
    set(THICKNESS_STEP, std::abs(t_m - t_l));
    set(THICKNESS_DIFFERENCE, t_m - t_l);
    set(THICKNESS_M, t_m);
    set(THICKNESS_L, t_l);
    set(SECTION_THICKNESS_M, t_s - t_m);
    set(SECTION_THICKNESS_L, t_s - t_l);
    set(THICKNESS_DEVIATION_M, thickness_deviation(m));
    set(THICKNESS_DEVIATION_L, thickness_deviation(l));
    set(THICKNESS_DEVIATION_U, thickness_deviation(u));
  }

  void set_widths(const Learned_section_data& section, const Shape& m, const Shape& l,
                  const Shape& u)
  {
    set(LENGTH_FOR_THICKNESS, log(section.length) - (std::min)(m.thickness, l.thickness));
    set(WIDTH_FOR_THICKNESS_M, log(m.width) - m.thickness);
    set(WIDTH_FOR_THICKNESS_L, log(l.width) - l.thickness);
    set(WIDTH_OF_BOTH, ratio(u.width, m.width + l.width));
    set(WIDTH_OF_LARGER, ratio(u.width, l.width));
  }

  void set_visibility(const Learned_section_data& section, const Learned_region_data& m,
                      const Learned_region_data& l)
  {
    set(VISIBILITY_M, ratio(section.visibility, (std::min)(m.visibility, l.visibility)));
    set(VISIBILITY_L, ratio(section.visibility, (std::max)(m.visibility, l.visibility)));
  }

  /// The features that are the same for m, M and u.
  void set_regions(const std::array<const Shape*, 3>& shapes)
  {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const Shape& shape = *shapes[i];
      set(OWN_VISIBILITY_M + i, shape.own_visibility);
      set(FLATNESS_M + i, ratio(shape.normal_length, shape.area));
      const auto w = internal::eigenvalues(shape.covariance);
      set(ELONGATION_M + i, root_of_ratio(w[1], w[0], w[0]));
      set(ROUNDNESS_M + i, root_of_ratio(w[2], w[1], w[0]));
      set(LOG_FILLING_M + i, log(shape.area) - log(CGAL_PI * shape.covariance.trace()));
    }
  }

  void set_pair(const Shape& m, const Shape& l, const Shape& u)
  {
    const Double_3 line = m.centroid - l.centroid;
    const double distance = norm(line);
    set(NORMALS, ratio(dot(m.area_vector, l.area_vector), m.normal_length * l.normal_length));
    set(OUTWARD, ratio(dot(m.area_vector, line), m.normal_length * distance) -
                   ratio(dot(l.area_vector, line), l.normal_length * distance));
    set(DISTANCE, distance / std::sqrt(u.area));
    set(ALIGNMENT, ratio(internal::trace_of_product(m.covariance, l.covariance),
                         m.covariance.trace() * l.covariance.trace()));
  }

  void set_whole(const Whole_shape& whole)
  {
    set(WHOLE_LOG_FILLING, whole.log_filling);
    set(WHOLE_FLATNESS, whole.flatness);
    set(WHOLE_STRONGLY_CONCAVE, whole.strongly_concave);
    set(WHOLE_RIGHT_ANGLES, whole.right_angles);
    set(WHOLE_OUTWARD, whole.outward);
  }

  void set(std::size_t feature, double value) { m_values[feature] = value; }

  Values rounded() const
  {
    constexpr double bound = 32767, steps = 1 << Model::feature_bits;
    Values result;
    for (std::size_t i = 0; i < m_values.size(); ++i) {
      const double nearest = std::floor(m_values[i] * steps + 0.5);
      result[i] = std::int16_t((std::max)(-bound, (std::min)(bound, nearest)));
    }
    return result;
  }

  static double log(double x) { return std::log((std::max)(x, smallest)); }

  static double ratio(double a, double b) { return b > smallest ? a / b : 0; }

  /// sqrt(a / b) of two eigenvalues; those that are nearly 0 beside the largest count as equal.
  static double root_of_ratio(double a, double b, double largest)
  {
    const double offset = 1e-6 * largest + smallest;
    return std::sqrt(((std::max)(a, 0.0) + offset) / ((std::max)(b, 0.0) + offset));
  }

  static double thickness_deviation(const Learned_region_data& region)
  {
    const double mean = region.mean_log_thickness();
    return std::sqrt(
      (std::max)(0.0, ratio(region.squared_log_thickness, region.area) - mean * mean));
  }

  static constexpr double smallest = 1e-12;
  static constexpr double least_perimeter = 1e-6; // of a component that is merged entirely

  std::array<double, NUMBER_OF_FEATURES> m_values;
};

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_MERGE_FEATURES_H
