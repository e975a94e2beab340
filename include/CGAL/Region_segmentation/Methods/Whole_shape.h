// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_METHODS_WHOLE_SHAPE_H
#define CGAL_REGION_SEGMENTATION_METHODS_WHOLE_SHAPE_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/internal/support/Second_moments.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Region_segmentation {

/// \ingroup PkgRegionSegmentationGraph
/// What kind of shape a surface is, of which regions are parts.
///
/// Sums are over the regions from which merging starts, of area a, area vector V and centroid c,
/// relative to that of the surface, or over their sections. A quotient of 0 by 0 is 0.
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
};

namespace internal {

/// The sums of \f$\cos^2\f$ and of \f$\cos^4\f$ of the angles over all pairs of weighted
/// directions, in linear time: by the sums of the monomials of degrees 2 and 4 in their
/// coordinates.
class Angle_sums
{
public:
  /// `v`: not zero; its length is its weight
  void add(const Double_3& v)
  {
    const double weight = norm(v);
    const Double_3 n = (1 / weight) * v;
    m_weight += weight;
    m_squares.add_square(weight, n);
    const Powers x = powers_of(n.x), y = powers_of(n.y), z = powers_of(n.z);
    for (std::size_t i = 0; i <= 4; ++i)
      for (std::size_t j = 0; i + j <= 4; ++j)
        m_fourth_powers[i][j] += weight * x[i] * y[j] * z[4 - i - j];
  }

  /// The mean of sin^2 of twice the angle; 0 if there is no pair.
  double mean_square_of_sine_of_double() const
  {
    if (!(m_weight > 0))
      return 0;
    constexpr double factorials[] = {1, 1, 2, 6, 24};
    double fourth_powers = 0;
    for (std::size_t i = 0; i <= 4; ++i)
      for (std::size_t j = 0; i + j <= 4; ++j)
        fourth_powers += 24 / (factorials[i] * factorials[j] * factorials[4 - i - j]) *
                         m_fourth_powers[i][j] * m_fourth_powers[i][j];
    return 4 * (trace_of_product(m_squares, m_squares) - fourth_powers) / (m_weight * m_weight);
  }

private:
  using Powers = std::array<double, 5>;

  static Powers powers_of(double x) { return {1, x, x * x, x * x * x, x * x * x * x}; }

  double m_weight = 0;
  Symmetric_3 m_squares;
  std::array<Powers, 5> m_fourth_powers{}; // of x^i y^j z^(4 - i - j)
};

/// \tparam Graph a `Region_adjacency_graph` with the data of `Learned_annotator`, of which no
/// regions are merged
template <typename Graph>
Whole_shape whole_shape(const Graph& graph)
{
  Second_moments moments;
  Angle_sums angles;
  double area = 0, area_vectors = 0;
  for (auto range = vertices(graph); range.first != range.second; ++range.first) {
    const auto& region = graph[*range.first];
    const double length = norm(region.area_vector);
    moments.add(region.moments);
    area += region.area;
    area_vectors += length;
    if (length > 0)
      angles.add(region.area_vector);
  }
  double outward = 0, distances = 0;
  for (auto range = vertices(graph); range.first != range.second; ++range.first) {
    const auto& region = graph[*range.first];
    const Double_3 c = region.moments.centroid() - moments.centroid();
    outward += dot(region.area_vector, c);
    distances += norm(region.area_vector) * norm(c);
  }
  double strongly_concave = 0, length = 0;
  for (auto range = edges(graph); range.first != range.second; ++range.first) {
    strongly_concave += graph[*range.first].strongly_concave_length;
    length += graph[*range.first].length;
  }
  const auto ratio = [](double a, double b) { return b > 0 ? a / b : 0; };
  Whole_shape result;
  result.log_filling = -std::log((std::max)(1e-12, CGAL_PI * moments.covariance().trace()));
  result.flatness = ratio(area_vectors, area);
  result.strongly_concave = ratio(strongly_concave, length);
  result.right_angles = 1 - angles.mean_square_of_sine_of_double();
  result.outward = ratio(outward, distances);
  return result;
}

} // namespace internal

} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_METHODS_WHOLE_SHAPE_H
