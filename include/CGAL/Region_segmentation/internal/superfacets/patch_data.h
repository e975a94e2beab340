// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_SUPERFACETS_PATCH_DATA_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_SUPERFACETS_PATCH_DATA_H

#include <CGAL/Region_segmentation/Double_3.h>
#include <CGAL/Region_segmentation/Execution.h>
#include <CGAL/Region_segmentation/Partition.h>
#include <CGAL/Region_segmentation/Patches.h>
#include <CGAL/Region_segmentation/Surface.h>
#include <CGAL/Region_segmentation/internal/support/arrays.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

// What patches have, for those who make and those who divide them.

constexpr Patches::Index no_center = (std::numeric_limits<Patches::Index>::max)();

/// The area of a patch and, after `end()`, its centroid, from zeros on. Elements are added relative
/// to the centroid of the first of them, to avoid cancellation far from the origin. (Trivial, so
/// that a large array of them is first touched by the threads that fill it.)
struct Patch_place
{
  Double_3 centroid;
  double area;

  void add(double area_of_element, const Double_3& from_first)
  {
    centroid = centroid + area_of_element * from_first;
    area += area_of_element;
  }
  void end(const Double_3& first) { centroid = first + (area > 0 ? 1 / area : 0) * centroid; }
};

/// The normal of a patch, after `end()`, from zeros on: the sum of the area vectors of its
/// elements, of length 1.
struct Patch_direction
{
  Double_3 normal;
  double projected_area; // on the plane of the normal: the length of the area vector

  void add(const Double_3& area_vector) { normal = normal + area_vector; }
  void end()
  {
    projected_area = norm(normal);
    normal = projected_area > 0 ? (1 / projected_area) * normal : Double_3{0, 0, 0};
  }
};

/// Finds the centers of patches among their elements: a degenerate one only if there is no other.
class Patch_centers
{
public:
  /// \pre those of which elements are offered have no center
  explicit Patch_centers(Large_array<Patches::Patch>& patches)
    : m_patches(patches)
    , m_distances(patches.size(), infinity)
  {}

  /// Those of a patch in order. `is_degenerate(element)` is asked of few.
  template <typename IsDegenerate>
  void offer(std::size_t patch, std::size_t element, const Double_3& centroid,
             const IsDegenerate& is_degenerate)
  {
    Patches::Patch& p = m_patches[patch];
    const double distance = squared_norm(centroid - p.centroid);
    const bool is_first = p.center == no_center;
    if (!is_first && !(distance < m_distances[patch]))
      return;
    const bool is_last_choice = is_degenerate(element);
    if (is_last_choice && !is_first)
      return;
    m_distances[patch] = is_last_choice ? infinity : distance;
    p.center = Patches::Index(element);
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Large_array<Patches::Patch>& m_patches;
  std::vector<double> m_distances; // of the centers, squared; infinite for degenerate ones
};

inline double concave_deviation(const Patches::Patch& a, const Patches::Patch& b)
{
  if (!(dot(b.normal - a.normal, b.centroid - a.centroid) < 0) || squared_norm(a.normal) == 0 ||
      squared_norm(b.normal) == 0)
    return 0;
  return std::acos((std::max)(-1.0, (std::min)(1.0, dot(a.normal, b.normal))));
}

/// By adjacency.
inline Large_array<double> concave_deviations(const Large_array<Patches::Patch>& patches,
                                              const Large_array<Patches::Adjacency>& adjacencies,
                                              const Execution& execution)
{
  Large_array<double> result(adjacencies.size());
  for_each_index(execution, result.size(), [&](std::size_t i) {
    result[i] = concave_deviation(patches[adjacencies[i].lower], patches[adjacencies[i].higher]);
  });
  return result;
}

/// The order of the adjacencies of patches.
inline bool is_before(const Patches::Adjacency& a, const Patches::Adjacency& b)
{
  return a.lower != b.lower ? a.lower < b.lower : a.higher < b.higher;
}

/// Adds up the lengths of subsequent adjacencies of the same two patches.
inline void unite(Large_array<Patches::Adjacency>& adjacencies)
{
  std::size_t n = 0;
  for (const Patches::Adjacency& a : adjacencies)
    if (n > 0 && adjacencies[n - 1].lower == a.lower && adjacencies[n - 1].higher == a.higher)
      adjacencies[n - 1].length += a.length;
    else
      adjacencies[n++] = a;
  adjacencies.resize(n);
  adjacencies.shrink_to_fit(); // large patches have many edges with each other
}

/// One for each two patches.
inline void sort_and_unite(Large_array<Patches::Adjacency>& adjacencies)
{
  std::stable_sort(adjacencies.begin(), adjacencies.end(), is_before);
  unite(adjacencies);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_SUPERFACETS_PATCH_DATA_H
