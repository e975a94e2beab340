// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_AREA_VECTOR_SUM_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_AREA_VECTOR_SUM_H

#include <CGAL/Region_segmentation/Double_3.h>

#include <algorithm>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The area vector of a polygon from its consecutive points: Newell's formula relative to the
/// first, A = 1/2 sum (p_i - p_0) x (p_i+1 - p_0), which avoids cancellation far from the origin.
class Area_vector_sum
{
public:
  Area_vector_sum(const Double_3& first, const Double_3& second)
    : m_first(first)
    , m_previous(second)
    , m_squared_longest_edge(squared_norm(second - first))
  {}

  void add(const Double_3& point)
  {
    m_twice_area = m_twice_area + cross(m_previous - m_first, point - m_first);
    m_squared_longest_edge = (std::max)(m_squared_longest_edge, squared_norm(point - m_previous));
    m_previous = point;
  }

  Double_3 area_vector() const { return 0.5 * m_twice_area; }
  double squared_longest_edge() const
  {
    return (std::max)(m_squared_longest_edge, squared_norm(m_previous - m_first));
  }

private:
  Double_3 m_first, m_previous, m_twice_area{};
  double m_squared_longest_edge;
};

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_AREA_VECTOR_SUM_H
