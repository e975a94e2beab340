// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MERGE_POINTS_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MERGE_POINTS_H

#include <CGAL/Region_segmentation/internal/surface/Raw_surface.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// The lowest index of equal points among those that were asked for; -0 is 0.
class Point_numbering
{
  using Index = Surface::Index;

public:
  Point_numbering(const Large_array<Double_3>& points, std::size_t expected_number)
    : m_points(points)
  {
    std::size_t capacity = 16;
    while (capacity < 2 * expected_number)
      capacity *= 2;
    m_table.assign(capacity, Index(Raw_surface::none));
  }

  /// \pre at most the expected number of different vertices are asked for
  Index operator()(Index v)
  {
    const Double_3& p = m_points[v];
    std::size_t hash = 0;
    for (const double coordinate : {p.x + 0.0, p.y + 0.0, p.z + 0.0})
      boost::hash_combine(hash, coordinate);
    std::size_t place = (hash ^ (hash >> (4 * sizeof hash))) & (m_table.size() - 1);
    while (m_table[place] != Raw_surface::none && !are_equal(p, m_points[m_table[place]]))
      place = (place + 1) & (m_table.size() - 1);
    if (m_table[place] == Raw_surface::none)
      m_table[place] = v;
    return m_table[place];
  }

private:
  static bool are_equal(const Double_3& p, const Double_3& q)
  {
    return p.x == q.x && p.y == q.y && p.z == q.z;
  }

  const Large_array<Double_3>& m_points;
  std::vector<Index> m_table;
};

/// Makes equal points one vertex, the lowest, as far as they are at sides whose neighbor is not
/// known.
inline void merge_points_of_open_sides(Raw_surface& raw)
{
  using Index = Surface::Index;
  Surface_arrays& arrays = arrays_of(raw.surface);
  std::vector<bool> is_at_open_side(arrays.points.size());
  for (const auto& [face, side] : raw.open_sides)
    is_at_open_side[arrays.corners[side]] = is_at_open_side[arrays.corners[next_corner(
      arrays, face, side)]] = true;
  std::vector<Index> lowest; // by vertex; empty: the same
  Point_numbering number(
    arrays.points, std::size_t(std::count(is_at_open_side.begin(), is_at_open_side.end(), true)));
  for (Index v = 0; v < is_at_open_side.size(); ++v)
    if (is_at_open_side[v])
      if (const Index first = number(v); first != v) {
        if (lowest.empty()) {
          lowest.resize(arrays.points.size());
          std::iota(lowest.begin(), lowest.end(), Index(0));
        }
        lowest[v] = first;
      }
  if (lowest.empty())
    return;
  for (Index& v : arrays.corners)
    v = lowest[v];
  begin_at_lowest_vertices(raw, Execution());
  find_open_sides(raw);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SURFACE_MERGE_POINTS_H
