// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_REGION_SEGMENTATION_INTERNAL_FACES_JOIN_TORI_TO_FREEFORM_H
#define CGAL_REGION_SEGMENTATION_INTERNAL_FACES_JOIN_TORI_TO_FREEFORM_H

#include <CGAL/Region_segmentation/internal/faces/Face_search.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Region_segmentation {
namespace internal {

/// Whether a face beside a torus departs from it much less than a plane that is tangent to its
/// tube.
inline bool departs_gradually(const Face_search& search, const Fitted_surface& torus,
                              Surface::Index face, std::size_t adjacency)
{
  const Surface& surface = search.surface;
  const double height = 2 * surface.area(face) / surface.length(adjacency);
  return search.test.largest_distance(torus, face) < 0.02 * height * height / torus.minor_radius &&
         search.test.has_normal_of(torus, face);
}

/// A fillet along a curve is freeform, but osculated by tori; where one of them was found, the
/// freeform face beside it goes on with nearly the same curvature, and is the same face.
inline void join_tori_to_freeform(Face_search& search)
{
  using Index = Surface::Index;
  struct Border
  {
    Index torus, freeform;
    double length, gradual;
  };
  const Surface& surface = search.surface;
  std::vector<Border> borders;
  const auto add = [&](Index f, Index g, std::size_t a) {
    const Index i = search.labels[f], j = search.labels[g];
    if (search.surfaces[i].kind == Surface_kind::TORUS &&
        search.surfaces[j].kind == Surface_kind::FREEFORM)
      borders.push_back(
        {i, j, surface.length(a),
         departs_gradually(search, search.surfaces[i], g, a) ? surface.length(a) : 0});
  };
  for (std::size_t a = 0; a < surface.number_of_adjacencies(); ++a)
    if (!surface.has_flag(a, Surface::LINK)) {
      add(surface.lower_face(a), surface.higher_face(a), a);
      add(surface.higher_face(a), surface.lower_face(a), a);
    }
  const auto key = [](const Border& b) { return std::tie(b.torus, b.freeform); };
  std::stable_sort(borders.begin(), borders.end(),
                   [&](const Border& a, const Border& b) { return key(a) < key(b); });

  std::vector<double> areas(search.surfaces.size(), 0);
  for (Index f = 0; f < search.labels.size(); ++f)
    areas[search.labels[f]] += surface.area(f);
  std::vector<Index> now = search.unchanged_labels();
  for (std::size_t first = 0, last; first < borders.size(); first = last) {
    const Index torus = borders[first].torus, freeform = borders[first].freeform;
    double length = 0, gradual = 0;
    for (last = first; last < borders.size() && key(borders[last]) == key(borders[first]); ++last) {
      length += borders[last].length;
      gradual += borders[last].gradual;
    }
    if (gradual > 0.7 * length && areas[freeform] > 0.3 * areas[torus] && now[torus] == torus)
      now[torus] = freeform;
  }
  search.relabel(now);
}

} // namespace internal
} // namespace Region_segmentation
} // namespace CGAL

#endif // CGAL_REGION_SEGMENTATION_INTERNAL_FACES_JOIN_TORI_TO_FREEFORM_H
